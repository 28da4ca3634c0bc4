// SPDX-License-Identifier: BSD-3-Clause
// The report of a block in a real browser: it agrees with patches.csv, its colours change, and every square leads to its page.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';
import { freshWork, readJson, ridgeline, work } from './results.mjs';

let browser;
const report = join(work, 'block', 'report.html');
const shot = (page, name) => page.screenshot({ path: join(work, 'screenshots', `${name}.png`), fullPage: true });

async function openReport(file = report, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  return open(context, file);
}

async function close(page) {
  assert.deepEqual(page.problems, []);
  await page.context().close();
}

/** The rows of patches.csv; no field before the reason has a comma. */
function rows() {
  const [head, ...lines] = readFileSync(join(work, 'block', 'patches.csv'), 'utf8').trim().split('\n');
  const names = head.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, i) => [names[i], value])));
}

const fills = (page) => page.locator('#plan .sheet a.shade > rect:first-child').evaluateAll((all) => all.map((r) => r.getAttribute('fill')));
const chooseColour = (page, key) => page.getByLabel('Colour of the squares').selectOption(key);

before(async () => {
  freshWork();
  const scene = join(work, 'scene');
  ridgeline('simulate', '--out', scene, '--seed', '3', '--extent-m', '45,45', '--samples-per-side', '1', '--focal-length-px', '4000', '--views', 'strip:3', '--orientation', 'opk');
  const block = join(scene, 'block.yaml');
  writeFileSync(block, `block: "<b>small"
crs: EPSG:25832
height_range: auto
orientation: opk.csv
cameras: cameras.yaml
images: "*.tif"
lidar: [lidar.las]
area: [513000, 5403000, 513045, 5403045]
patch_size_m: 30
overlap_m: 10
reference_lines: truth.geojson
`);
  const step = (...which) => ridgeline('block', block, '--out', join(work, 'block'), ...which);
  step('--plan');
  step('--task', '1-3');
  assert.throws(() => step('--merge'), /1 of 4/); // one task has not run
  browser = await launch({ webgl: false });
});
after(async () => browser?.close());

test('shows the figures of patches.csv, the failed patch and the fixed sentence', async () => {
  const page = await openReport();
  await shot(page, 'block');
  const done = rows().filter((r) => r.status === 'done');
  assert.equal(done.length, 3);
  for (const row of rows()) {
    const label = await page.locator(`#plan a[data-patch="${row.patch}"]`).getAttribute('aria-label');
    if (row.status === 'failed') assert.match(label, /failed: /);
    else if (row.n_lines === '0') assert.match(label, /no lines$/);
    else assert.ok(label.includes(`RMS distance ${Number(row.rms_m).toFixed(3)} m`), label);
  }
  const worst = done.filter((r) => r.rms_m !== '').sort((a, b) => b.rms_m - a.rms_m)[0];
  assert.match(await page.locator('#patch-table tbody tr').first().innerText(), new RegExp(`^${worst.patch}`));
  assert.equal(await page.locator('#failed-table tbody tr').count(), 1);
  assert.match(await page.locator('#failures').innerText(), /^1 of 4 patches failed/);
  const { note } = readJson('block', 'table2.json');
  assert.ok((await page.locator('#fixed-sentence').innerText()).endsWith(note));
  assert.equal(await page.locator('h1').innerText(), 'Block <b>small: line reconstruction report');
  await close(page);
});

test('another figure has other fills and another legend', async () => {
  const page = await openReport();
  const before = await fills(page);
  const legend = await page.locator('#plan-legend').innerText();
  await chooseColour(page, 'lines');
  assert.notDeepEqual(await fills(page), before);
  assert.notEqual(await page.locator('#plan-legend').innerText(), legend);
  await chooseColour(page, 'rms');
  assert.deepEqual(await fills(page), before);
  // with all lines the shades stand at the rims
  await page.getByLabel('Lines', { exact: true }).selectOption('all');
  assert.ok((await fills(page)).every((fill) => fill === 'none'));
  assert.match(await page.locator('#lines-shown').innerText(), /All \d+ lines are shown/);
  await page.getByLabel('LIDAR heights').check();
  const grey = await page.locator('canvas.relief').evaluate((c) => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some((v) => v > 0));
  assert.ok(grey);
  await shot(page, 'block-lines');
  await close(page);
});

test('pointing at a square shows its figures, a click opens its page and there is a way back', async () => {
  const page = await openReport();
  const row = rows().find((r) => Number(r.n_evaluated) > 0);
  const square = page.locator(`#plan a[data-patch="${row.patch}"] rect`).first();
  await square.hover();
  assert.ok((await page.locator('#patch-info').innerText()).includes(`${row.n_evaluated} of ${row.n_lines}`));
  await square.click();
  await page.waitForSelector('html[data-ready] #line-table');
  assert.equal(await page.locator('h1').innerText(), `Patch ${row.patch}`);
  assert.equal(await page.locator('#line-table tbody tr').count(), Number(row.n_lines));
  assert.equal(await page.locator('#patch-plan g.line').count(), Number(row.n_lines));
  await page.locator('#line-table tbody tr').first().hover();
  assert.match(await page.locator('#pointed').innerText(), /^Line \d+: \d\.\d+ m/);
  await shot(page, 'block-patch');
  await page.locator('#back').click();
  await page.waitForSelector('html[data-ready] #plan');
  await close(page);
});

test('keys go from square to square and open a page', async () => {
  const page = await openReport();
  const focused = () => page.evaluate(() => document.activeElement.dataset.patch);
  const ids = rows().map((r) => r.patch); // south-west, north-west, south-east, north-east
  await page.locator('#plan a[tabindex="0"]').focus();
  assert.equal(await page.locator('#plan a[tabindex="0"]').count(), 1);
  assert.equal(await focused(), ids[0]);
  await page.keyboard.press('ArrowUp');
  assert.equal(await focused(), ids[1]);
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), ids[3]);
  await page.keyboard.press('ArrowRight'); // nothing is there
  assert.equal(await focused(), ids[3]);
  assert.ok((await page.locator('#patch-info').innerText()).includes(ids[3]));
  await page.keyboard.press('Enter');
  await page.waitForSelector('html[data-ready] #reason');
  assert.match(await page.locator('#reason').innerText(), /^This patch has no lines/);
  await close(page);
});

test('a first tap shows the figures, a second one opens the page', async () => {
  const page = await openReport(report, { hasTouch: true, viewport: { width: 390, height: 844 } });
  const square = page.locator(`#plan a[data-patch="${rows()[0].patch}"] rect`).first();
  await square.tap();
  assert.ok((await page.locator('#patch-info').innerText()).includes(rows()[0].patch));
  assert.equal(await page.locator('#plan').count(), 1);
  await square.tap();
  await page.waitForSelector('html[data-ready] #line-table');
  await close(page);
});

test('tables are sorted by their columns', async () => {
  const page = await openReport();
  await page.locator('#patch-table button[data-key="n_lines"]').click();
  const shown = await page.locator('#patch-table tbody tr td:nth-child(5)').allInnerTexts();
  assert.deepEqual(shown.map(Number), rows().filter((r) => r.status === 'done').map((r) => Number(r.n_lines)).sort((a, b) => b - a));
  assert.equal(await page.locator('#patch-table th[aria-sort="descending"]').count(), 1);
  await close(page);
});

test('`ridgeline report` makes the same bytes, and --no-report removes report and pages', async () => {
  const bytes = readFileSync(report);
  ridgeline('report', join(work, 'block'));
  assert.ok(bytes.equals(readFileSync(report)));
  assert.throws(() => ridgeline('block', join(work, 'scene', 'block.yaml'), '--out', join(work, 'block'), '--merge', '--no-report'));
  assert.throws(() => readFileSync(report), /ENOENT/);
  assert.throws(() => readFileSync(join(work, 'block', 'pages', `${rows()[0].patch}.html`)), /ENOENT/);
});
