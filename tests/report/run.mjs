// SPDX-License-Identifier: BSD-3-Clause
// What ctest calls: node run.mjs RIDGELINE_BINARY SAMPLE_DATA WORK_DIR. Exit code 77 (skipped) where
// Chromium or playwright-core is missing.
import { existsSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const needs = [
  ['/usr/bin/chromium', 'apt-get install --no-install-recommends chromium'],
  [`${here}node_modules/playwright-core`, 'npm ci --prefix tests/report'],
];
for (const [file, remedy] of needs) {
  if (existsSync(file)) continue;
  console.log(`Skipped: ${file} is missing (${remedy})`);
  process.exit(77);
}
const [binary, samples, work] = process.argv.slice(2);
let status = 0;
for (const [file, folder] of [['report_test.mjs', work], ['block_test.mjs', join(work, 'block_test')], ['edges_test.mjs', join(work, 'edges_test')]]) {
  const result = spawnSync(process.execPath, ['--test', `${here}${file}`], {
    stdio: 'inherit',
    env: { ...process.env, RIDGELINE_BINARY: binary, RIDGELINE_SAMPLES: samples, RIDGELINE_WORK: folder },
  });
  status ||= result.status ?? 1;
}
process.exit(status);
