// SPDX-License-Identifier: BSD-3-Clause
// A page of a report in Debian's Chromium, with software WebGL and without a network.
import { chromium } from 'playwright-core';
import { pathToFileURL } from 'node:url';

export const chromiumPath = '/usr/bin/chromium';

export async function launch({ webgl = true } = {}) {
  const gl = webgl
    ? ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
    : ['--disable-gpu', '--disable-3d-apis'];
  return chromium.launch({
    executablePath: chromiumPath,
    headless: true,
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', ...gl],
  });
}

/** Opens a report; `page.problems` collects console errors, exceptions and requests for anything else. */
export async function open(context, file) {
  const page = await context.newPage();
  page.setDefaultTimeout(120000); // ms; ends a test that hangs, also on a busy machine
  const problems = [];
  page.on('console', (message) => { if (message.type() === 'error') problems.push(`console: ${message.text()}`); });
  page.on('pageerror', (error) => problems.push(`exception: ${error.message}`));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) problems.push(`request: ${request.url()}`); });
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector('html[data-ready]').catch(() => { throw new Error(`not ready: ${problems.join('; ')}`); });
  await drawn(page);
  return Object.assign(page, { problems });
}

/** Waits until what was changed is drawn: the page draws its scene with the next frame. */
export async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** The work of a page so far: the nodes that Chromium has made for it, and how often it drew its scene. */
export async function workOf(page) {
  const client = await page.context().newCDPSession(page);
  await client.send('Performance.enable');
  const { metrics } = await client.send('Performance.getMetrics');
  const frames = await page.evaluate(() => globalThis.ridgeline.scene.nFrames);
  return { nodes: metrics.find((metric) => metric.name === 'Nodes').value, frames };
}
