// SPDX-License-Identifier: BSD-3-Clause
// Compares our decoding of LAZ files, record by record, with laz-perf's, an independent decoder.
//   npm ci && node compare.mjs LAZ_DUMP FILE.laz...
// Exit code 0: equal; 1: different; 77: laz-perf or a file is absent, nothing was compared.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';

const SKIPPED = 77;
const [dump, ...files] = process.argv.slice(2);

const lazPerf = await import('laz-perf').catch(() => undefined);
const missing = files.find((file) => !existsSync(file));
if (!lazPerf || missing) {
  console.log(missing ? `${missing} is absent` : 'laz-perf is not installed (npm ci)');
  process.exit(SKIPPED);
}
const wasm = await lazPerf.createLazPerf();

function decodeWithLazPerf(file) {
  const data = readFileSync(file);
  const filePointer = wasm._malloc(data.length);
  wasm.HEAPU8.set(data, filePointer);
  const reader = new wasm.LASZip();
  reader.open(filePointer, data.length);
  const length = reader.getPointLength();
  const records = Buffer.alloc(length * reader.getCount());
  const pointPointer = wasm._malloc(length);
  for (let offset = 0; offset < records.length; offset += length) {
    reader.getPoint(pointPointer);
    records.set(wasm.HEAPU8.subarray(pointPointer, pointPointer + length), offset);
  }
  wasm._free(pointPointer);
  wasm._free(filePointer);
  reader.delete();
  return { records, length };
}

let isEqual = true;
for (const file of files) {
  const { records, length } = decodeWithLazPerf(file);
  const ours = execFileSync(dump, [file], { maxBuffer: 2 ** 31 });
  const equal = ours.equals(records);
  const count = records.length / length;
  console.log(`${equal ? 'equal' : 'DIFFERENT'}: ${count} records of ${length} bytes: ${file}`);
  isEqual &&= equal && count > 0;
}
process.exit(isEqual ? 0 : 1);
