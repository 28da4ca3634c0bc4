// SPDX-License-Identifier: BSD-3-Clause
// Folders of results to look at, made by the program as a user would.
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const binary = process.env.RIDGELINE_BINARY;
export const samples = process.env.RIDGELINE_SAMPLES;
export const work = process.env.RIDGELINE_WORK;

export function ridgeline(...args) {
  const result = spawnSync(binary, args, { encoding: 'utf8' });
  if (result.status !== 0) throw new Error(`ridgeline ${args.join(' ')}: ${result.stderr}`);
  return result.stdout;
}

export const readJson = (...path) => JSON.parse(readFileSync(join(work, ...path), 'utf8'));

export function freshWork() {
  rmSync(work, { recursive: true, force: true });
  mkdirSync(join(work, 'screenshots'), { recursive: true });
}

/** A copy of the first sample's patch file, its text changed, with absolute paths of its data. */
export function patchFile(name, change) {
  const text = readFileSync(join(samples, '1/patch.yaml'), 'utf8').replace(/(path: |- |: )(left\.tif|right\.tif|lidar\.las|matches\.csv|truth\.geojson)/g,
    (_, key, file) => `${key}${join(samples, '1', file)}`);
  const file = join(work, name);
  writeFileSync(file, change(text));
  return file;
}

const feature = (properties, from, to) => ({ type: 'Feature', properties, geometry: { type: 'LineString', coordinates: [from, to] } });

export function geoJson(name, features) {
  const file = join(work, name);
  writeFileSync(file, JSON.stringify({ type: 'FeatureCollection', crs: { type: 'name', properties: { name: 'urn:ogc:def:crs:EPSG::25832' } }, features }));
  return file;
}

export const hostileId = '</script><script>globalThis.hacked = 1</script><img src=x onerror="globalThis.hacked = 2">';
export const hostilePatch = `<script>globalThis.hacked=3<"'&`;

/** Lines with hostile ids beside a cloud with a hostile name. */
export function hostileLines() {
  const cloud = join(work, `li<dar>'".las`);
  copyFileSync(join(samples, '1/lidar.las'), cloud);
  const lines = geoJson(`<b>'".geojson`, [
    feature({ id: hostileId, class: '<i>class</i>' }, [513010, 5403030, 249.5], [513020, 5403035, 249.8]),
    feature({ id: `"quoted" 'id' & <b>` }, [513030, 5403040, 250], [513040, 5403041, 250.2]),
  ]);
  return { lines, cloud };
}
