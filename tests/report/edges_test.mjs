// SPDX-License-Identifier: BSD-3-Clause
// The page of the edges of a cloud in a real browser: its figures agree with the lines, kinds can be switched off, and a section marks its edge.
import assert from 'node:assert/strict';
import { copyFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, launch, open } from './browser.mjs';
import { freshWork, readJson, ridgeline, samples, work } from './results.mjs';

let browser;
let page;

/** How many pixels of the lines' canvas are drawn on. */
const inked = () => page.locator('#plan canvas.lines').evaluate((canvas) => {
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  let n = 0;
  for (let i = 3; i < data.length; i += 4) n += data[i] > 0 ? 1 : 0;
  return n;
});

before(async () => {
  freshWork();
  const cloud = join(work, `li<dar>'".las`);
  copyFileSync(join(samples, '1/lidar.las'), cloud);
  ridgeline('edges', '--cloud', cloud, '--out', join(work, 'edges.geojson'));
  browser = await launch();
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  page = await open(context, join(work, 'edges.html'));
  await page.screenshot({ path: join(work, 'screenshots', 'edges.png'), fullPage: true });
});

after(async () => {
  assert.deepEqual(page.problems, []);
  await browser.close();
});

test('counts the edges of the file by kind', async () => {
  const { features } = readJson('edges.geojson');
  const rows = await page.locator('#kinds tbody tr').evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  for (const [kind, n] of rows) {
    const expected = features.filter((f) => kind === 'total' || f.properties.kind === kind).length;
    assert.equal(Number(n), expected, kind);
  }
  assert.equal(rows.at(-1)[0], 'total');
});

test('draws the edges of the kinds that are switched on', async () => {
  const all = await inked();
  assert.ok(all > 1000);
  await page.getByRole('checkbox', { name: 'eave' }).uncheck();
  await drawn(page);
  assert.ok(await inked() < all);
  await page.getByRole('checkbox', { name: 'eave' }).check();
});

test('marks the edge of a section', async () => {
  const before = await inked();
  await page.locator('#sections figure').first().hover();
  await drawn(page);
  assert.ok(await inked() > before);
});

test('shows foreign names as text', async () => {
  assert.equal(await page.locator('h1').textContent(), `Edges of li<dar>'"`);
});
