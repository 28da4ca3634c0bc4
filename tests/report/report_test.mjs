// SPDX-License-Identifier: BSD-3-Clause
// The report in a real browser: what it shows agrees with the files beside it, everything selects
// everywhere, a review comes out as a reference that `run` takes, and nothing in the data is markup.
import assert from 'node:assert/strict';
import { copyFileSync, mkdirSync, readFileSync, renameSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawn, launch, open, workOf } from './browser.mjs';
import { geoJson, freshWork, hostileId, hostileLines, hostilePatch, patchFile, readJson, ridgeline, samples, work } from './results.mjs';

let browser;
const report = (folder) => join(work, folder, 'report.html');
const shot = (page, name) => page.screenshot({ path: join(work, 'screenshots', `${name}.png`) });
const textOf = (page, selector) => page.locator(selector).allInnerTexts();
const metres = (value) => (value === null ? '–' : value.toFixed(3).replace('-', '\u2212'));

async function openReport(folder, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  return open(context, report(folder));
}

/** What is selected, and what the page can do for a test. */
const selection = (page) => page.evaluate(() => globalThis.ridgeline.state.now);

/** Where the 3D view is, scrolled into sight below the heading that stays on top. */
async function sceneBox(page) {
  await page.locator('#scene-panel').evaluate((e) => e.scrollIntoView({ block: 'start' }));
  return page.locator('#scene canvas').boundingBox();
}

async function close(page) {
  assert.deepEqual(page.problems, []);
  await page.context().close();
}

async function downloadOf(page, action) {
  const [download] = await Promise.all([page.waitForEvent('download'), action()]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
}

before(async () => {
  freshWork();
  ridgeline('run', ...['1', '2', '3'].map((patch) => join(samples, patch, 'patch.yaml')), '--out', join(work, 'demo'), '--methods', 'direct,joint');
  browser = await launch();
});
after(async () => browser?.close());

test('three patches fit into 8 MB and open with little work', async () => {
  const bytes = statSync(report('demo')).size;
  assert.ok(bytes < 8e6, `${bytes} bytes`);
  const page = await openReport('demo');
  const { nodes, frames } = await workOf(page);
  assert.ok(nodes < 20000, `${nodes} nodes; 13018 when this was written`);
  assert.ok(frames <= 4, `the scene was drawn ${frames} times; twice when this was written`);
  await shot(page, 'top');
  await close(page);
});

/** The figures of the lines that plan and images decided on, or of all where the judge did not say. */
const headlineOf = (row) => row.decided_by?.plan_images ?? row;

/** The rows that tables show of a class: three where points or the place of some lines decided. */
function rowsOf(row) {
  if (!row.decided_by?.points_place?.n_evaluated) return [row];
  const of = (name, figures) => ({ ...figures, patch: row.patch, method: row.method, class: `${row.class} ${name}` });
  return [of('plan_images', row.decided_by.plan_images), of('points_place', row.decided_by.points_place), of('all', row)];
}

test('opens on the product method with the figure that counts, a plan and the worst lines', async () => {
  const page = await openReport('demo');
  const state = await selection(page);
  assert.equal(await page.evaluate(() => globalThis.ridgeline.state.method.name), 'joint');
  const rows = readJson('demo/table2.json').rows.filter((r) => r.method === 'joint' && r.class === 'total');
  const figures = rows.map(headlineOf);
  const n = figures.reduce((sum, r) => sum + r.n_evaluated, 0);
  const rms = Math.sqrt(figures.reduce((sum, r) => sum + r.rms_m ** 2 * r.n_evaluated, 0) / n);
  assert.equal(await page.locator('#key-figure .value').innerText(), `${metres(rms)} m`);
  assert.match(await page.locator('#verdict').innerText(), /^No acceptance limits were given/);
  const lines = readJson('demo', rows[0].patch, 'evaluation.joint.json').lines;
  const worst = lines.filter((l) => l.mean_distance_m !== null && ['plan', 'images'].includes(l.decided_by)).sort((a, b) => b.mean_distance_m - a.mean_distance_m);
  const captions = await textOf(page, '#worst figcaption');
  const total = headlineOf(readJson('demo', rows[0].patch, 'evaluation.joint.json').summary.total);
  assert.equal(captions.length, Math.max(5, Math.min(12, total.n_half_of_squares)));
  assert.equal(await page.locator('#half-of-squares').innerText(),
    `${total.n_half_of_squares} of ${total.n_evaluated} lines contribute half of the sum of squares; RMS of the others ${metres(total.rms_without_half_m)} m.`
    + (total.n_half_of_squares > captions.length ? ` Shown: the first ${captions.length}.` : ''));
  // they come first in the list of all lines as well
  const first = await page.locator('#line-table tbody tr').evaluateAll((all) => all.map((row) => [Number(row.dataset.line), row.className]));
  assert.deepEqual(first.slice(0, total.n_half_of_squares), worst.slice(0, total.n_half_of_squares).map((l) => [lines.indexOf(l), 'half']));
  assert.equal(first[total.n_half_of_squares][1], '');
  assert.match(await page.locator('#worst h3').innerText(), new RegExp(`patch ${rows[0].patch}, method joint$`));
  assert.match(await page.locator('#key-figure').innerText(), new RegExp(`over ${rows.length} patches`));
  assert.ok(captions[0].startsWith(`${worst[0].id} ${metres(worst[0].mean_distance_m)} m`), captions[0]);
  assert.ok(await page.locator('#plan svg line').count() > 0.9 * worst.length);
  // selecting a line there moves the camera
  const before = await page.evaluate(() => globalThis.ridgeline.scene.screenPositionOf(0));
  await page.locator('#worst figcaption button').first().click();
  const line = (await selection(page)).line;
  assert.notEqual(line, state.line);
  const at = await page.evaluate((i) => globalThis.ridgeline.scene.screenPositionOf(i), line);
  const box = await page.locator('#scene canvas').boundingBox();
  assert.ok(Math.hypot(at[0] - box.width / 2, at[1] - box.height / 2) < 3, `${at} of ${box.width} x ${box.height}, before ${before}`);
  await close(page);
});

test('prints, and its acceptance page fits onto A4', async () => {
  const page = await openReport('demo', { viewport: { width: 688, height: 1017 } }); // A4 less margins of 14 mm, 96 dpi
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
  const box = /\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/.exec(pdf);
  assert.ok(Math.abs(box[1] - 595.3) < 1 && Math.abs(box[2] - 841.9) < 1, box[0]); // points of A4
  await page.emulateMedia({ media: 'print' });
  const { y, height } = await page.locator('#acceptance').boundingBox();
  assert.ok(y + height < 1017, `ends at ${y + height} px of the page's 1017`);
  await close(page);
});

test('an evaluation has a title, panels and facts of its own', async () => {
  const { lines, cloud } = hostileLines();
  ridgeline('evaluate', '--lines', lines, '--cloud', cloud, '--out', join(work, 'facts'), '--project', '<b>P</b>', '--operator', 'O', '--date', '2026-11-25');
  const page = await openReport('facts');
  assert.equal(await page.locator('h1').innerText(), 'Accuracy of 3D lines against LIDAR');
  assert.equal(await page.locator('#table1, #table1-missing, #images').count(), 0);
  const facts = await page.locator('#facts').innerText();
  for (const text of ['<b>P</b>', 'O', '2026-11-25']) assert.ok(facts.includes(text), facts);
  await close(page);
});

test('lines name their surface, and those that the place decided on stand beside the headline', async () => {
  ridgeline('evaluate', '--lines', join(samples, '1', 'lines.fair.geojson'), '--cloud', join(samples, '1', 'lidar.las'), '--out', join(work, 'decided'), '--no-report');
  const file = join(work, 'decided', 'evaluation.lines.fair.json');
  const evaluation = JSON.parse(readFileSync(file, 'utf8'));
  const judged = evaluation.lines.filter((l) => l.mean_distance_m !== null).sort((a, b) => b.mean_distance_m - a.mean_distance_m);
  for (const line of judged) line.decided_by = 'plan';
  Object.assign(judged[0], { surface: 'lower', surface_other: 'object', surface_probability: 0.97, decided_by: 'place' });
  Object.assign(judged[1], { surface: 'upper', surface_other: 'ground', surface_probability: 0.995, decided_by: 'images' });
  writeFileSync(file, JSON.stringify(evaluation));
  ridgeline('report', join(work, 'decided'));
  const page = await openReport('decided');
  const rms = (lines) => metres(Math.sqrt(lines.reduce((sum, l) => sum + l.mean_distance_m ** 2, 0) / lines.length));
  const place = rms(judged.slice(0, 1));
  assert.equal(await page.locator('#key-figure .value').innerText(), `${rms(judged.slice(1))} m`);
  const about = await page.locator('#key-figure').innerText();
  assert.ok(about.includes(`1 more line decided by points or position, RMS ${place} m; all together ${rms(judged)} m.`), about);
  assert.ok((await page.locator('#table2 td').last().innerText()).includes(`+ ${place} 1/${evaluation.lines.length}`));
  const classes = await textOf(page, '#statistics tbody td:first-child');
  assert.deepEqual(classes.slice(-3), ['total plan images', 'total points place', 'total all']);
  const [caption] = await textOf(page, '#worst figcaption');
  assert.ok(caption.startsWith(`${judged[1].id} `) && caption.includes('edge of: upper, else ground'), caption);
  assert.equal(await page.getByRole('img', { name: `Section across line ${judged[1].id}, edge of: upper, else ground`, exact: true }).count(), 1);
  await page.evaluate((line) => globalThis.ridgeline.state.set({ line }), evaluation.lines.indexOf(judged[0]));
  assert.ok((await page.locator('#details').innerText()).includes('lower (97.0 %), else object; decided by place'));
  await shot(page, 'decided');
  await close(page);
});

test('of two line files one leads and is named at the figure, the other stands beside it', async () => {
  // the first leads even if the second has a method's name
  const joint = join(work, 'joint.geojson');
  copyFileSync(join(samples, '1', 'lines.poor.geojson'), joint);
  ridgeline('evaluate', '--lines', join(samples, '1', 'lines.fair.geojson'), joint, '--cloud', join(samples, '1', 'lidar.las'), '--out', join(work, 'two'));
  const page = await openReport('two');
  const rows = readJson('two/table2.json').rows.filter((r) => r.class === 'total');
  assert.equal(await page.locator('#key-figure .value').innerText(), `${metres(headlineOf(rows[0]).rms_m)} m`);
  assert.match(await page.locator('#key-figure').innerText(), /the lines of lines\.fair from/);
  const beside = await page.locator('#line-files tbody tr').allInnerTexts();
  for (const [i, name] of ['lines.fair', 'joint'].entries()) {
    const row = headlineOf(rows.find((r) => r.method === name));
    assert.deepEqual(beside[i].split('\t').slice(0, 3), [name, `${row.n_evaluated} of ${row.n_lines}`, metres(row.rms_m)]);
  }
  assert.match(await page.locator('#facts').innerText(), /Products/);
  assert.match(await page.locator('#worst h3').innerText(), /, lines\.fair$/);
  await page.locator('#line-files tbody button').nth(1).click();
  assert.match(await page.locator('#worst h3').innerText(), /, joint$/);
  assert.match(await page.locator('#plan figcaption').innerText(), /, joint\./);
  await close(page);
  const one = await openReport('facts');
  assert.equal(await one.locator('#line-files').count(), 0);
  await close(one);
});

test('warnings of the run are counted on top and lead to their texts', async () => {
  const lines = join(work, 'unstated.geojson');
  const document = JSON.parse(readFileSync(join(samples, '1', 'lines.fair.geojson'), 'utf8'));
  delete document.crs;
  writeFileSync(lines, JSON.stringify(document));
  ridgeline('evaluate', '--lines', lines, '--cloud', join(samples, '1', 'lidar.las'), '--out', join(work, 'warned'));
  const page = await openReport('warned');
  const { warnings } = readJson('warned/run.json');
  assert.ok(warnings.length > 0);
  assert.equal(await page.locator('#facts a').innerText(), `${warnings.length}, below`);
  const texts = await page.locator('#provenance p.caption').allInnerTexts();
  assert.deepEqual(texts, warnings.map((w) => `Warning: ${w.replace(`${work}/`, '')}`)); // paths are cut on the page
  await close(page);
});

test('tables hold the figures of the JSON files', async () => {
  const page = await openReport('demo');
  const table1 = await textOf(page, '#table1 tbody tr');
  for (const [i, row] of readJson('demo', 'table1.json').rows.entries()) {
    const cells = table1[i].split('\t');
    assert.deepEqual(cells.slice(0, 5), [row.patch, row.matcher, String(row.correct), String(row.false), String(row.missed)]);
    assert.ok(cells[7].startsWith((100 * row.quality).toFixed(1)), cells[7]);
  }
  const classes = readJson('demo', 'table2.json').rows;
  const rows = classes.flatMap(rowsOf);
  const all = page.locator('#table2-all tbody tr');
  assert.equal(await all.count(), rows.length);
  for (const [i, row] of rows.entries()) {
    const cells = await all.nth(i).locator('td').allTextContents();
    assert.deepEqual(cells.slice(0, 7), [row.patch, row.method, row.class.replaceAll('_', ' '), String(row.n_evaluated), String(row.n_lines),
      (100 * row.evaluated_share).toFixed(1), metres(row.rms_m)]);
  }
  const published = await page.locator('#table2 tbody td').allTextContents();
  const cell = (r) => `${metres(r.rms_m)} ${r.n_evaluated}/${r.n_lines}`;
  assert.deepEqual(published, classes.map((row) => rowsOf(row).slice(0, 2).map(cell).join(' + ')));
  const { footnote } = readJson('demo', 'table2.json');
  assert.match(footnote, /faces_beside/);
  assert.equal(await page.locator('#table2-footnote').innerText(), footnote);
  await close(page);
});

test('shows the measures of standards with their ids, and the parts of a ridge', async () => {
  const page = await openReport('demo');
  const evaluation = readJson('demo', '1', 'evaluation.joint.json');
  await page.locator('#standards summary').click();
  const { total } = evaluation.standards;
  assert.deepEqual(await textOf(page, '#iso19157 tbody tr td:first-child'), total.iso19157.map((m) => String(m.id)));
  const rmse = total.iso19157.find((m) => m.id === 39);
  assert.ok((await textOf(page, '#iso19157 tbody tr')).some((row) => row.startsWith('39') && row.includes(rmse.value.toFixed(4))));
  assert.ok((await page.locator('#asprs').innerText()).includes(metres(total.asprs.rmse_horizontal_m)));
  const ridge = evaluation.lines.findIndex((l) => l.displacement);
  const { horizontal_m, covariance_m2 } = evaluation.lines[ridge].displacement;
  await page.evaluate((line) => globalThis.ridgeline.state.set({ line }), ridge);
  const details = await page.locator('#details').innerText();
  assert.ok(details.includes(`${metres(horizontal_m)} ± ${metres(1.96 * Math.sqrt(covariance_m2[0][0]))} m across in plan`), details);
  await close(page);
});

test('a row of the table selects the line everywhere, by mouse and by keys', async () => {
  const page = await openReport('demo');
  const lines = readJson('demo', '1', 'evaluation.joint.json').lines;
  await page.locator('#line-table tbody tr[data-line="4"]').click();
  assert.equal((await selection(page)).line, 4);
  assert.match(await page.locator('#details h3').innerText(), new RegExp(`Line ${lines[4].id}$`));
  assert.ok((await page.locator('#details').innerText()).includes(`${metres(lines[4].mean_distance_m)} m on average`));
  assert.equal(await page.locator('#details .chips canvas').count(), 2);
  assert.equal(await page.locator('#line-planes tbody tr').count(), lines[4].planes.length);
  const rows = await page.locator('#line-table tbody tr').evaluateAll((all) => all.map((row) => Number(row.dataset.line)));
  const at = rows.indexOf(4);
  const steps = at + 2 < rows.length ? ['ArrowDown', 2] : ['ArrowUp', -2];
  await page.keyboard.press(steps[0]);
  await page.keyboard.press(steps[0]);
  assert.equal((await selection(page)).line, rows[at + steps[1]]);
  assert.equal(await page.locator('#line-table tr[aria-selected]').getAttribute('data-line'), String(rows[at + steps[1]]));
  await shot(page, 'selected');
  await page.keyboard.press('Escape');
  assert.equal((await selection(page)).line, null);
  await close(page);
});

test('a click in 3D selects a line', async () => {
  const page = await openReport('demo');
  const box = await sceneBox(page);
  await page.keyboard.press('t');
  await drawn(page);
  const lines = readJson('demo', '1', 'evaluation.joint.json').lines;
  const longest = lines.map((line, i) => ({ i, length: line.length_m })).sort((a, b) => b.length - a.length).slice(0, 12);
  let hit = 0;
  for (const { i } of longest) {
    const at = await page.evaluate((line) => globalThis.ridgeline.scene.screenPositionOf(line), i);
    if (!at || at[0] < 5 || at[1] < 5 || at[0] > box.width - 5 || at[1] > box.height - 5) continue;
    await page.mouse.click(box.x + at[0], box.y + at[1]);
    if ((await selection(page)).line !== i) continue; // another one lies across it
    ++hit;
    assert.match(await page.locator('#details h3').innerText(), new RegExp(`Line ${lines[i].id}$`));
  }
  assert.ok(hit >= 6, `${hit} of the 12 longest lines were hit`);
  await shot(page, 'top-view');
  await close(page);
});

test('the 3D view shows points and lines and turns', async () => {
  const page = await openReport('demo');
  const colours = () => page.evaluate(() => {
    const source = document.querySelector('#scene canvas');
    const copy = Object.assign(document.createElement('canvas'), { width: 200, height: 150 });
    const g = copy.getContext('2d');
    g.drawImage(source, 0, 0, 200, 150);
    const pixels = new Uint32Array(g.getImageData(0, 0, 200, 150).data.buffer);
    return { n: new Set(pixels).size, sum: pixels.reduce((a, b) => (a * 31 + b) >>> 0, 7) };
  });
  const start = await colours();
  assert.ok(start.n > 100, `${start.n} colours`);
  const box = await sceneBox(page);
  await page.mouse.move(box.x + 300, box.y + 250);
  await page.mouse.down();
  await page.mouse.move(box.x + 420, box.y + 300, { steps: 5 });
  await page.mouse.up();
  await drawn(page);
  assert.notEqual((await colours()).sum, start.sum);
  for (const colouring of ['status', 'distance']) {
    await page.locator('#scene-panel select').selectOption(colouring);
  }
  await page.locator('#scene-panel input[type=range]').fill('3');
  await page.getByRole('checkbox', { name: 'planes' }).check();
  await drawn(page);
  await shot(page, 'planes-and-heights');
  await close(page);
});

/** Pixels of the 3D view in the violet of the surface's points, which no line by class and no plane has. */
const surfacePixels = (page) => page.evaluate(() => new Promise((done) => {
  requestAnimationFrame(() => requestAnimationFrame(() => {
    const source = document.querySelector('#scene canvas');
    const copy = Object.assign(document.createElement('canvas'), { width: source.width, height: source.height });
    const g = copy.getContext('2d');
    g.drawImage(source, 0, 0);
    const { data } = g.getImageData(0, 0, copy.width, copy.height);
    let n = 0;
    for (let i = 0; i < data.length; i += 4) {
      const [red, green, blue] = data.subarray(i, i + 3);
      if (blue > red && red > 1.1 * green && blue > 1.3 * green) ++n;
    }
    done(n);
  }));
}));

test('the surface is a layer of its own beside the LIDAR points', async () => {
  const page = await openReport('demo');
  await sceneBox(page);
  const box = page.getByRole('checkbox', { name: 'surface' });
  assert.ok(!(await box.isChecked()));
  assert.equal(await surfacePixels(page), 0);
  await box.check();
  const shown = await surfacePixels(page);
  assert.ok(shown > 10000, `${shown} pixels`);
  await shot(page, 'surface');
  await page.locator('#theme').click();
  await sceneBox(page);
  const dark = await surfacePixels(page);
  assert.ok(dark > 10000, `${dark} pixels in the dark`);
  await shot(page, 'surface-dark');
  // what was chosen holds for the next patch
  await page.locator('#patches button').nth(1).click();
  assert.ok(await box.isChecked());
  await box.uncheck();
  assert.equal(await surfacePixels(page), 0);
  await close(page);
});

test('a run without a surface has no box for it', async () => {
  const patch = patchFile('no_surface.yaml', (text) => text);
  ridgeline('run', patch, '--out', join(work, 'no_surface'), '--methods', 'direct', '--preset', 'published');
  const page = await openReport('no_surface');
  assert.equal(await page.getByRole('checkbox', { name: 'LIDAR' }).count(), 1);
  assert.equal(await page.getByRole('checkbox', { name: 'surface' }).count(), 0);
  assert.doesNotMatch(await page.locator('#scene-panel').innerText(), /surface/);
  await close(page);
});

test('measuring takes two clicks', async () => {
  const page = await openReport('demo');
  await page.locator('#measure').click();
  const box = await sceneBox(page);
  for (const x of [0.4, 0.6]) await page.mouse.click(box.x + x * box.width, box.y + 0.6 * box.height);
  assert.match(await page.locator('#measured').innerText(), /^Distance \d+\.\d{3} m, in plan/);
  assert.equal((await selection(page)).line, null);
  await close(page);
});

test('the method switch changes lines, charts and figures, and keeps the line', async () => {
  const page = await openReport('demo');
  await page.locator('#methods button').nth(0).click();
  await page.locator('#line-table tbody tr[data-line="4"]').click();
  const direct = await page.locator('#statistics').innerText();
  await page.locator('#methods button').nth(1).click();
  assert.equal((await selection(page)).method, 1);
  const joint = readJson('demo', '1', 'evaluation.joint.json');
  const shown = ['not_aligned', 'aligned', 'total'].flatMap((name) => rowsOf({ ...joint.summary[name], class: name }));
  const rms = await page.locator('#statistics tbody td:nth-child(5)').allInnerTexts();
  assert.deepEqual(rms, shown.map((row) => metres(row.rms_m)));
  assert.notEqual(await page.locator('#statistics').innerText(), direct);
  const common = readFileSync(join(work, 'demo', 'table2.common.csv'), 'utf8').split('\n').filter((row) => /^1,(direct|joint),total,/.test(row)).map((row) => row.split(','));
  const paired = await page.locator('.paired').innerText();
  for (const row of common) assert.ok(paired.includes(`${row[1]} ${row[5]} m`), `${paired}: ${row}`);
  assert.match(await page.locator('#details h3').innerText(), /Line 4$/);
  assert.match(await page.locator('#charts h3').innerText(), /joint/);
  assert.deepEqual(await page.locator('#charts figure').evaluateAll((all) => all.map((f) => f.id)),
    ['chart-histogram', 'chart-cumulative', 'chart-qq', 'chart-angle', 'chart-truth', 'chart-chi-square']);
  await page.keyboard.press('1');
  assert.equal((await selection(page)).method, 0);
  await page.locator('#charts').scrollIntoViewIfNeeded();
  await shot(page, 'charts');
  await close(page);
});

test('the table sorts, filters and exports', async () => {
  const page = await openReport('demo');
  const lines = readJson('demo', '1', 'evaluation.joint.json').lines;
  const header = page.locator('#line-table th button[data-key="mean_distance_m"]');
  await header.click();
  await header.click();
  assert.equal(await page.locator('#line-table th[aria-sort="descending"]').count(), 1);
  const largest = Math.max(...lines.map((l) => l.mean_distance_m ?? -1));
  assert.ok((await page.locator('#line-table tbody tr').first().innerText()).includes(metres(largest)));
  await page.locator('#line-filter').fill('ridge');
  const ridges = lines.filter((l) => l.kind === 'ridge' || l.flags.some((f) => f.includes('ridge')));
  assert.equal(await page.locator('#line-table tbody tr').count(), ridges.length);
  const csv = await downloadOf(page, () => page.locator('#export-lines').click());
  assert.equal(csv.name, 'lines.1.joint.csv');
  assert.equal(csv.text.trim().split('\n').length, ridges.length + 1);
  assert.ok(csv.text.startsWith('id,class,status,kind,'));
  await close(page);
});

test('a click on a segment in an image selects its line', async () => {
  const page = await openReport('demo');
  const { data, box } = await imageData(page, 0);
  const match = data.pairs[0].matches[0];
  await page.mouse.click(...onScreen(box, data.views[0], middle(data.views[0], match.left)));
  const { line } = await selection(page);
  assert.deepEqual(await page.evaluate((i) => globalThis.ridgeline.state.method.lines[i].observations[0].slice(0, 2), line), [0, match.left]);
  await close(page);
});

/** The images of the first patch and where the canvas of one of them is. */
async function imageData(page, view) {
  const canvas = page.locator(`#image-${view} canvas`);
  await canvas.scrollIntoViewIfNeeded();
  const data = await page.evaluate(() => globalThis.ridgeline.state.patch.images);
  return { data, box: await canvas.boundingBox() };
}

/** The ends of a view's segments: x1, y1, x2, y2. */
function segmentsOf(view) {
  const values = new Float32Array(new Uint8Array(Buffer.from(view.segments, 'base64')).buffer);
  return Array.from({ length: values.length / 4 }, (_, i) => values.subarray(4 * i, 4 * i + 4));
}

function middle(view, segment) {
  const [x1, y1, x2, y2] = segmentsOf(view)[segment];
  return [(x1 + x2) / 2, (y1 + y2) / 2];
}

function longestOf(view, excluded) {
  const lengths = segmentsOf(view).map(([x1, y1, x2, y2], i) => (excluded.has(i) ? 0 : Math.hypot(x2 - x1, y2 - y1)));
  return lengths.indexOf(Math.max(...lengths));
}

/** The canvas fits the whole image until it is zoomed. */
function onScreen(box, view, [x, y]) {
  const scale = Math.min((box.width - 2) / view.width_px, (box.height - 2) / view.height_px);
  return [box.x + box.width / 2 + (x + 0.5 - view.width_px / 2) * scale, box.y + box.height / 2 + (y + 0.5 - view.height_px / 2) * scale];
}

test('a review is kept, and its export is a reference that run takes', async () => {
  const page = await openReport('demo');
  await page.locator('#review-start').click();
  await page.keyboard.press('c');
  await page.keyboard.press('f');
  await page.keyboard.press('u');
  await shot(page, 'review');
  assert.match(await page.locator('#review-counts').innerText(), /^3 of \d+ matches judged: 1 correct, 1 false, 1 unsure; 0 missed/);
  const judged = (await page.evaluate(() => globalThis.ridgeline.state.patch.images.pairs[0].matches)).slice(0, 2);

  // a missed match, of the longest segments that no match has
  const { pairs: [{ matches }], views } = await page.evaluate(() => globalThis.ridgeline.state.patch.images);
  const missed = [longestOf(views[0], new Set(matches.map((m) => m.left))), longestOf(views[1], new Set(matches.map((m) => m.right)))];
  await page.getByRole('button', { name: 'Fit' }).click();
  await page.keyboard.press('m');
  for (const view of [0, 1]) {
    const { box } = await imageData(page, view);
    await page.mouse.click(...onScreen(box, views[view], middle(views[view], missed[view])));
  }
  assert.match(await page.locator('#review-counts').innerText(), /1 missed added/);

  await page.reload();
  await page.waitForSelector('html[data-ready]');
  assert.match(await page.locator('#review-counts').innerText(), /^3 of \d+ matches judged: 1 correct, 1 false, 1 unsure; 1 missed/);
  const csv = await downloadOf(page, () => page.locator('#review-export').click());
  await close(page);
  assert.equal(csv.name, 'reference_matches.csv');
  const rows = csv.text.trim().split('\n');
  assert.equal(rows[0], 'id,verdict,left_x1_px,left_y1_px,left_x2_px,left_y2_px,right_x1_px,right_y1_px,right_x2_px,right_y2_px');
  assert.deepEqual(rows.slice(1, 3).map((r) => r.split(',').slice(0, 2)),
    [[`${judged[0].left}-${judged[0].right}`, 'correct'], [`${judged[1].left}-${judged[1].right}`, 'false']]);
  assert.equal(rows.length, 4);

  const folder = join(work, 'reviewed');
  mkdirSync(folder, { recursive: true });
  const reference = join(folder, 'reference_matches.csv');
  writeFileSync(reference, csv.text);
  const patch = patchFile('reviewed/patch.yaml', (text) => text.replace(/reference_matches: .*/, `reference_matches: ${reference}`));
  ridgeline('run', patch, '--out', join(folder, 'results'), '--no-report');
  const [row] = readJson('reviewed', 'results', 'table1.json').rows;
  assert.deepEqual([row.correct, row.false, row.missed], [1, 1, 1]);
});

test('light, dark and print', async () => {
  const page = await openReport('demo', { colorScheme: 'dark' });
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await background(), 'rgb(21, 24, 28)');
  await page.locator('#patch').evaluate((e) => e.scrollIntoView());
  await drawn(page);
  await shot(page, 'dark');
  await page.locator('#theme').click();
  assert.equal(await background(), 'rgb(251, 251, 250)');
  await page.emulateMedia({ media: 'print' });
  assert.equal(await background(), 'rgb(255, 255, 255)');
  assert.ok(!(await page.locator('#export-lines').isVisible()));
  await shot(page, 'print');
  await close(page);
});

test('a report without lines', async () => {
  ridgeline('evaluate', '--lines', geoJson('none.geojson', []), '--cloud', join(samples, '1/lidar.las'), '--out', join(work, 'no_lines'));
  const page = await openReport('no_lines');
  assert.equal(await page.locator('#line-table tbody tr').count(), 0);
  assert.match(await page.locator('#charts').innerText(), /No line was evaluated/);
  assert.ok(!(await page.locator('body').innerText()).match(/NaN|undefined|null/));
  await shot(page, 'no-lines');
  await close(page);
});

test('a patch without LIDAR, and without reference matches', async () => {
  const patch = patchFile('no_lidar.yaml', (text) => text.replace(/lidar:\n\s*- .*\n/, '').replace(/reference_matches: .*\n/, '').replace(/reference_lines: .*\n?/, ''));
  ridgeline('run', patch, '--out', join(work, 'no_lidar'));
  const page = await openReport('no_lidar');
  assert.match(await page.locator('.note').innerText(), /no LIDAR/);
  assert.ok(await page.getByRole('checkbox', { name: 'surface' }).isChecked());
  assert.ok(await page.locator('#table1-missing').isVisible());
  await page.locator('#line-table tbody tr').first().click();
  assert.match(await page.locator('#details').innerText(), /no lidar/);
  assert.ok(!(await page.locator('body').innerText()).match(/NaN|undefined|null/));
  await shot(page, 'no-lidar');
  await close(page);
});

test('names with markup and quotes stay text', async () => {
  const { lines, cloud } = hostileLines();
  ridgeline('evaluate', '--lines', lines, '--cloud', cloud, '--out', join(work, 'hostile'));
  const page = await openReport('hostile');
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  const row = page.locator('#line-table tbody tr[data-line="0"]');
  assert.equal(await row.locator('td').first().textContent(), hostileId);
  await row.click();
  assert.equal(await page.locator('#details h3').textContent(), `Line ${hostileId}`);
  assert.ok((await page.locator('#inputs').textContent()).includes(`li<dar>'".las`));
  assert.equal(await page.locator('img[src="x"]').count(), 0);
  await close(page);

  const patch = patchFile('hostile.yaml', (text) => text.replace('id: "1"', `id: ${JSON.stringify(hostilePatch)}`).replace('id: left', `id: 'le"ft<b>'`));
  ridgeline('run', patch, '--out', join(work, 'hostile_patch'));
  const second = await openReport('hostile_patch');
  assert.equal(await second.evaluate(() => globalThis.hacked), undefined);
  assert.ok((await second.locator('#patch h2').textContent()).includes(hostilePatch));
  assert.equal(await second.title(), `Ridgeline report: ${hostilePatch}`);
  await close(second);
});

test('without WebGL everything else is there', async () => {
  const plain = await launch({ webgl: false });
  const page = await open(await plain.newContext(), report('demo'));
  assert.ok(await page.locator('#no-webgl').isVisible());
  await page.locator('#line-table tbody tr').first().click();
  assert.equal(await page.locator('#details .chips canvas').count(), 2);
  assert.equal(await page.locator('#table2 tbody tr').count(), 3);
  await shot(page, 'no-webgl');
  await plain.close();
});

test('a report made later, when the data is gone, says what is missing', async () => {
  const results = join(work, 'moved');
  const patch = patchFile('moved.yaml', (text) => text);
  ridgeline('run', patch, '--out', results, '--no-report');
  renameSync(patch, `${patch}.gone`);
  ridgeline('report', results);
  const page = await openReport('moved');
  assert.match((await textOf(page, '.note')).join(' '), /moved\.yaml: no longer exists/);
  assert.ok((await page.locator('#line-table tbody tr').count()) > 100);
  await close(page);
});

/** Sample 1 with cameras of a lens that moves its pixels by one to three pixels. The pictures are not distorted so: all lines are
 * wrong a little, but those of two segments fit both of them. */
function lensPatch() {
  const camera = (id, position, angles, window) => `  - id: ${id}
    path: ${join(samples, '1', `${id}.tif`)}
    interior: {focal_length_mm: 120, pixel_size_um: 12, size_px: [7681, 13825], k1: -0.1, p1: 0.002}
    exterior: {position_m: [${position}], omega_phi_kappa_deg: [${angles}]}
    window_px: [${window}]
`;
  const file = join(work, 'lens.yaml');
  writeFileSync(file, 'id: lens\ncrs: EPSG:25832\nheight_range: [220, 290]\nimages:\n'
    + camera('left', '512928.620, 5403034.364, 1050.927', '-0.545313, 0.856515, 0.237101', '4903, 6463')
    + camera('right', '513136.040, 5403031.240, 1049.419', '-0.357483, -0.083388, -0.394998', '2146, 6457'));
  return file;
}

test('draws projected lines and epipolar lines where a lens with distortion shows them', async () => {
  ridgeline('run', lensPatch(), '--out', join(work, 'lens'), '--methods', 'direct');
  const page = await openReport('lens');
  const { lines, n, seen, epipolar, moved } = await page.evaluate(() => {
    const images = globalThis.ridgeline.images();
    const distance = (curve, [x, y]) => Math.min(...curve.slice(1).map(([x2, y2], i) => {
      const [x1, y1] = curve[i];
      const t = Math.max(0, Math.min(1, ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / ((x2 - x1) ** 2 + (y2 - y1) ** 2)));
      return Math.hypot(x - x1 - t * (x2 - x1), y - y1 - t * (y2 - y1));
    }));
    const project = ([a, b, c, d, e, f, g, h, i, j, k, l], [x, y, z]) => [(a * x + b * y + c * z + d) / (i * x + j * y + k * z + l), (e * x + f * y + g * z + h) / (i * x + j * y + k * z + l)];
    const isWithin = ({ projection, width_px, height_px }, x) => { const [c, r] = project(projection, x); return c > 20 && r > 20 && c < width_px - 20 && r < height_px - 20; };
    const isWhole = (l) => images.images.views.every((view) => isWithin(view, l.start) && isWithin(view, l.end));
    const found = { lines: 0, n: 0, seen: 0, epipolar: 0, moved: [] };
    for (const line of globalThis.ridgeline.state.method.lines.filter((l) => l.start && l.class === 'not_aligned' && l.construction === 'direct' && isWhole(l))) {
      ++found.lines;
      for (const v of [0, 1]) {
        const [x1, y1, x2, y2] = images.segmentsOfLine(v, line)[0];
        const middle = [(x1 + x2) / 2, (y1 + y2) / 2];
        ++found.n;
        found.seen += distance(images.projectedCurve(v, line), middle) < 0.7;
        const there = images.projected(v, line);
        const ideal = project(images.images.views[v].projection, line.start);
        found.moved.push(Math.hypot(there[0] - ideal[0], there[1] - ideal[1]));
        // the point of the other image at which the line is seen lies on the epipolar line of this one
        const other = images.projected(1 - v, line);
        found.epipolar += distance(images.epipolarCurve(1 - v, v, [there[0], there[1]]), [other[0], other[1]]) < 0.05;
      }
    }
    return found;
  });
  assert.ok(lines > 20, `${lines} lines`);
  assert.ok(seen > 0.9 * n, `${seen} of ${n} segments on the projected line`);
  assert.equal(epipolar, n);
  assert.ok(moved.sort((a, b) => a - b)[Math.floor(moved.length / 2)] > 1.5, 'the lens moves pixels');
  await close(page);
});

/** A small village in five images of two crossing strips, with a line that an image contradicts. */
function fiveImages() {
  const patch = join(work, 'five_patch');
  ridgeline('simulate', '--out', patch, '--seed', '3', '--extent-m', '40,40', '--samples-per-side', '1', '--focal-length-px', '7000', '--views', 'strip:3,cross:2');
  ridgeline('run', join(patch, 'patch.yaml'), '--out', join(work, 'five'), '--no-report');
  const file = join(work, 'five', 'five_patch', 'lines.lines.geojson');
  const lines = JSON.parse(readFileSync(file, 'utf8'));
  const moved = lines.features.find((f) => f.properties.n_images === 5).properties;
  const observation = moved.observations.findIndex((s) => s[0] === 'cross1');
  moved.observations[observation] = moved.observations[observation].map((v, i) => (i === 0 ? v : v + 15));
  writeFileSync(file, JSON.stringify(lines));
  ridgeline('report', join(work, 'five'));
  return { contradicted: moved.id };
}
let five;
const openFive = async () => { five ??= fiveImages(); return openReport('five'); };
const lineWhere = (page, condition) => page.evaluate(`globalThis.ridgeline.state.method.lines.findIndex((l) => ${condition})`);
const selectLine = (page, line) => page.evaluate((i) => globalThis.ridgeline.state.set({ line: i }), line);
const shownImages = (page) => page.locator('#images figure').evaluateAll((all) => all.map((f) => f.id));

test('each of five images has a panel for a line, with a word on what it shows', async () => {
  const page = await openFive();
  const bytes = statSync(report('five')).size;
  console.log(`five images: ${(bytes / 1e6).toFixed(2)} MB`);
  assert.ok(bytes < 2.5e6, `${bytes} bytes`);
  await selectLine(page, await lineWhere(page, `l.n_images === 5 && l.id !== '${five.contradicted}'`));
  const captions = await textOf(page, '#details .chips figcaption');
  assert.equal(captions.length, 5);
  for (const caption of captions) assert.match(caption, /^(strip|cross)\d: agrees, \d+\.\d\d px off, sigma \d+\.\d\d px$/);
  assert.match(await page.locator('#details').innerText(), /5 of 5 images show it\n/);
  assert.equal(await page.locator('figure.disagrees').count(), 0);
  await page.locator('#details').evaluate((e) => e.scrollIntoView());
  await shot(page, 'five-images');

  await selectLine(page, await lineWhere(page, `l.id === '${five.contradicted}'`));
  assert.match(await page.locator('#details').innerText(), /5 of 5 images show it; cross1 differs\n/);
  const differing = await textOf(page, 'figure.disagrees figcaption');
  assert.equal(differing.length, 1);
  assert.match(differing[0], /^cross1: differs, \d/);
  await shot(page, 'an-image-differs');

  await selectLine(page, await lineWhere(page, "l.status === 'unconfirmed'"));
  const missing = await textOf(page, 'figure.disagrees figcaption');
  assert.ok(missing.length > 0);
  for (const caption of missing) assert.match(caption, /: missing, it should show the line$/);
  assert.match(await page.locator('#details').innerText(), /2 of 5 images show it; missing in (strip|cross)\d/);
  await shot(page, 'unconfirmed');
  await close(page);
});

test('epipolar lines pass through the mates in any pair of images', async () => {
  const page = await openFive();
  const { n, farthest_px } = await page.evaluate(() => {
    const { state, images: get } = globalThis.ridgeline;
    const images = get();
    const result = { n: 0, farthest_px: 0 };
    for (const line of state.method.lines.filter((l) => l.start)) {
      for (let v = 0; v < images.count; ++v) {
        for (let other = 0; other < images.count; ++other) {
          if (other === v) continue;
          const [x, y] = images.projected(v, line);
          const curve = images.epipolarCurve(v, other, images.projected(other, line).slice(0, 2));
          if (!curve) continue; // beside the image
          const [[x1, y1], [x2, y2]] = curve; // without distortion a straight line
          const off_px = Math.abs((x2 - x1) * (y - y1) - (y2 - y1) * (x - x1)) / Math.hypot(x2 - x1, y2 - y1);
          result.farthest_px = Math.max(result.farthest_px, off_px);
          ++result.n;
        }
      }
    }
    return result;
  });
  assert.ok(n > 20 * 20 && farthest_px < 1e-4, `${n} points up to ${farthest_px} px off`);
  await close(page);
});

test('the images of a line are shown until somebody chooses a pair, and further ones beside it', async () => {
  const page = await openFive();
  assert.deepEqual(await shownImages(page), ['image-0', 'image-1']);
  const other = await lineWhere(page, 'l.observations.length > 1 && l.observations[1][0] > 1 && l.observations[0][0] !== l.observations[1][0]');
  const views = await page.evaluate((i) => globalThis.ridgeline.state.method.lines[i].observations.map((s) => s[0]), other);
  await selectLine(page, other);
  assert.deepEqual((await shownImages(page)).sort(), views.slice(0, 2).map((v) => `image-${v}`).sort());
  assert.match(await page.locator(`#image-${views[0]} figcaption`).innerText(), /\): agrees, /);
  // a click in an image leaves the images as they are
  const fixed = await shownImages(page);
  await page.locator('#image-choice select').selectOption('0');
  assert.deepEqual(await shownImages(page), ['image-0', 'image-1']);
  await selectLine(page, await lineWhere(page, 'l.n_images === 5'));
  await selectLine(page, other);
  assert.deepEqual(await shownImages(page), ['image-0', 'image-1']);
  await page.locator('#image-choice button').last().click();
  assert.deepEqual(await shownImages(page), ['image-0', 'image-1', 'image-4']);
  await page.locator('#image-choice select').selectOption('line');
  assert.deepEqual((await shownImages(page)).slice(0, 2), fixed);
  await close(page);
});

test('a click in an image leaves the images as they are', async () => {
  const page = await openFive();
  const { pair, segment, line } = await page.evaluate(() => {
    const { state, images } = globalThis.ridgeline;
    const i = state.method.lines.findIndex((l) => l.observations[0][0] === 0 && l.observations[1][0] === 1);
    return { pair: images().pairOf(1, 3), segment: images().segmentsOfLine(1, state.method.lines[i])[0], line: i };
  });
  await page.evaluate(() => globalThis.ridgeline.state.set({ line: null }));
  await page.evaluate((p) => globalThis.ridgeline.state.set({ pair: p }), pair);
  const { data, box } = await imageData(page, 1);
  await page.mouse.click(...onScreen(box, data.views[1], [(segment[0] + segment[2]) / 2, (segment[1] + segment[3]) / 2]));
  assert.equal((await selection(page)).line, line);
  assert.deepEqual(await shownImages(page), ['image-1', 'image-3']);
  await close(page);
});

/** A copy of the patch of five images whose first two are others. */
function patchBeginningWith(names, reference) {
  const text = readFileSync(join(work, 'five_patch', 'patch.yaml'), 'utf8').replace(/(path: |- |: )(\w+\.(?:tif|las|csv|geojson))/g, (_, key, file) => `${key}${join(work, 'five_patch', file)}`);
  const [head, ...rest] = text.split('  - id: ');
  const end = rest[rest.length - 1].search(/\n\w/) + 1; // where the keys after the images begin
  const tail = rest[rest.length - 1].slice(end).replace(/reference_matches: .*/, `reference_matches: ${reference}`);
  rest[rest.length - 1] = rest[rest.length - 1].slice(0, end);
  const rank = (image) => (names.indexOf(image.split('\n')[0]) + 1 || 9);
  const file = join(work, 'other_pair.yaml');
  writeFileSync(file, head + rest.sort((a, b) => rank(a) - rank(b)).map((image) => `  - id: ${image}`).join('') + tail);
  return file;
}

test('the matches of any pair can be reviewed, and its export is a reference of that pair', async () => {
  const page = await openFive();
  const names = ['strip1', 'cross2'];
  const choosePair = async () => {
    const option = await page.locator('#image-choice option').evaluateAll((all, [a, b]) => all.find((o) => o.text.startsWith(`${a} – ${b}`)).value, names);
    await page.locator('#image-choice select').selectOption(option);
  };
  await choosePair();
  assert.match(await page.locator('#review').innerText(), /These are the matches of strip1 – cross2, matched by the run/);
  await page.locator('#review-start').click();
  assert.deepEqual(await shownImages(page), ['image-2', 'image-4']);
  await page.keyboard.press('c');
  await page.keyboard.press('c');
  await page.keyboard.press('f');
  await shot(page, 'review-of-another-pair');
  assert.match(await page.locator('#review-counts').innerText(), /^3 of \d+ matches judged: 2 correct, 1 false/);
  const csv = await downloadOf(page, () => page.locator('#review-export').click());
  assert.equal(csv.name, 'reference_matches.strip1-cross2.csv');
  // the base pair has a review of its own, and that of this pair is kept
  await page.locator('#image-choice select').selectOption('0');
  assert.equal(await page.locator('#review-counts').count(), 0);
  await page.reload();
  await page.waitForSelector('html[data-ready]');
  await choosePair();
  assert.match(await page.locator('#review-counts').innerText(), /^3 of \d+ matches judged/);
  // tracks give matches of a pair that was not matched
  const joined = await page.locator('#image-choice option').evaluateAll((all) => all.find((o) => o.text.startsWith('strip2 – cross1')).value);
  await page.locator('#image-choice select').selectOption(joined);
  assert.match(await page.locator('#review').innerText(), /strip2 – cross1, derived from tracks/);
  const tracks = await page.evaluate(() => globalThis.ridgeline.state.patch.images.tracks.filter((t) => [0, 3].every((v) => t.some((x, i) => i % 2 === 0 && x === v))).length);
  await page.locator('#review-start').click();
  assert.match(await page.locator('#review-match').innerText(), new RegExp(`^Match 1 of ${tracks}: segments \\d+ and \\d+\\. Judged`));
  await close(page);

  const reference = join(work, 'reference_matches.strip1-cross2.csv');
  writeFileSync(reference, csv.text);
  ridgeline('run', patchBeginningWith(names, reference), '--out', join(work, 'other_pair'), '--no-report', '--methods', 'direct');
  const [row] = readJson('other_pair', 'table1.json').rows;
  assert.deepEqual([row.correct, row.false], [2, 1]);
});

test('lines are filtered by the number of their images, and unconfirmed ones are counted', async () => {
  const page = await openFive();
  const { lines } = await page.evaluate(() => ({ lines: globalThis.ridgeline.state.method.lines.map((l) => [l.status, l.n_images]) }));
  const unconfirmed = lines.filter(([status]) => status === 'unconfirmed').length;
  assert.ok(unconfirmed > 0);
  assert.match(await page.locator('#patch-facts').innerText(), new RegExp(`lines: ${lines.length} lines, .* ${unconfirmed} unconfirmed\\.`));
  const choose = (label, value) => page.locator('#lines').getByLabel(label, { exact: true }).selectOption(value);
  await choose('status', 'unconfirmed');
  assert.match(await page.locator('#line-count').innerText(), new RegExp(`^${unconfirmed} of ${lines.length} lines`));
  await choose('status', '');
  await choose('images', '3');
  const three = lines.filter(([, n]) => n === 3).length;
  assert.match(await page.locator('#line-count').innerText(), new RegExp(`^${three} of ${lines.length} lines`));
  assert.equal(await page.locator('#line-table th button[data-key="n_images"]').count(), 1);
  await close(page);
});

test('a report of two images speaks of no further ones', async () => {
  const page = await openReport('demo');
  await page.locator('#line-table tbody tr').first().click();
  assert.equal(await page.locator('#image-choice').innerText(), '');
  assert.equal(await page.locator('#line-table th button[data-key="n_images"]').count(), 0);
  assert.deepEqual(await textOf(page, '#details .chips figcaption'), ['left', 'right']);
  assert.doesNotMatch(await page.locator('#patch').innerText(), /agrees|unconfirmed|Magenta|base pair/);
  await close(page);
});

test('gates give the verdict', async () => {
  const gates = join(work, 'gates.yaml');
  writeFileSync(gates, 'gates:\n  - {class: total, metric: rms_m, max: 0.001}\n');
  ridgeline('report', join(work, 'demo'), '--gates', gates);
  const page = await openReport('demo');
  assert.match(await page.locator('#verdict').innerText(), /^Not accepted: 3 of 3 checks failed: /);
  assert.equal(await page.locator('#gates tbody tr').count(), 3);
  await close(page);
});

test('tracks are counted by the number of images that show their true edges', async () => {
  const page = await openFive();
  const rows = await page.evaluate(() => [...document.querySelectorAll('#table1-tracks tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent)));
  const judged = JSON.parse(readFileSync(join(work, 'five', 'table1.json'), 'utf8')).tracks[0].cells.filter((c) => c.class === 'total' && c.edges > 0);
  assert.deepEqual(rows.map((row) => row[1]), judged.map((c) => c.n_images === null ? 'all' : c.n_images === 5 ? '5 and more' : `${c.n_images}`));
  assert.deepEqual(rows.map((row) => row[2]), judged.map((c) => `${c.edges}`));
  assert.equal(rows[0][6], (100 * judged[0].observation_precision).toFixed(1));
  await close(page);
});
