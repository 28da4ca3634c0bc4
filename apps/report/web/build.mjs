// SPDX-License-Identifier: BSD-3-Clause
// Bundles the front end into ../dist (or the folder given), the same bytes on every machine.
import { build } from 'esbuild';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const out = process.argv[2] ?? join(here, '../dist');

// The licences ask to travel with every copy, and every report is one.
const licences = await Promise.all(['three', 'uplot'].map(async (name) =>
  `${name}\n${(await readFile(join(here, 'node_modules', name, 'LICENSE'), 'utf8')).trim()}`));

const common = { bundle: true, minify: true, legalComments: 'none', logLevel: 'warning', absWorkingDir: here };
await build({
  ...common,
  entryPoints: ['src/main.ts'],
  outfile: join(out, 'report.js'),
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  banner: { js: `/*!\n${licences.join('\n\n')}\n*/` },
});
await build({ ...common, entryPoints: ['src/style/report.css'], outfile: join(out, 'report.css') });
// The report of a block and the pages of its patches: a page each, so that none of the libraries above is in it.
await build({ ...common, entryPoints: ['src/block/main.ts'], outfile: join(out, 'block.js'), format: 'iife', target: 'es2022', charset: 'ascii' });
await build({ ...common, entryPoints: ['src/style/block.css'], outfile: join(out, 'block.css') });
// The page of the edges of a point cloud.
await build({ ...common, entryPoints: ['src/edges/main.ts'], outfile: join(out, 'edges.js'), format: 'iife', target: 'es2022', charset: 'ascii' });
await build({ ...common, entryPoints: ['src/style/edges.css'], outfile: join(out, 'edges.css') });

// The bundle stands inside a script element and a style element.
for (const [file, end] of [['report.js', /<\/script|<!--/i], ['report.css', /<\/style/i], ['block.js', /<\/script|<!--/i], ['block.css', /<\/style/i], ['edges.js', /<\/script|<!--/i], ['edges.css', /<\/style/i]]) {
  if (end.test(await readFile(join(out, file), 'utf8'))) throw new Error(`${file} would end its element`);
}
