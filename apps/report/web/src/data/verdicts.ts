// SPDX-License-Identifier: BSD-3-Clause
// The verdicts on buildings, the worst first, in the style of the map, and a sentence about each.
import { metres } from '../ui/format';
import { okabeIto } from './colours';
import type { Building } from './schema';

export const verdicts = ['gone', 'changed', 'faces missing', 'shifted', 'too high', 'too low', 'wrong height', 'wrong tilt', 'wrong outline', 'not judged', 'right'];

/** Solid for errors in height, dashed for errors in plan; map_style.cpp has the same styles. */
const looks: Record<string, { colour: string; dash?: string }> = {
  gone: { colour: okabeIto.purple, dash: '5 3' },
  changed: { colour: okabeIto.purple },
  'faces missing': { colour: okabeIto.purple },
  shifted: { colour: okabeIto.vermillion, dash: '5 3' },
  'too high': { colour: okabeIto.vermillion },
  'too low': { colour: okabeIto.vermillion },
  'wrong height': { colour: okabeIto.orange },
  'wrong tilt': { colour: okabeIto.orange, dash: '6 2 1 2' },
  'wrong outline': { colour: okabeIto.orange, dash: '5 3' },
  right: { colour: okabeIto.blue },
};
export const lookOf = (verdict: string): { colour: string; dash?: string } => looks[verdict] ?? { colour: okabeIto.grey };

/** Limit for the lines of a building; kOutlineTolerance_m of evaluate/faces/limits.h. */
const mostRms_m = 0.3;

/** What is wrong with a building, in one sentence. */
export function reasonOf(building: Building): string {
  const { shift_x_m: x, shift_y_m: y, shift_z_m: z } = building;
  const shift = x === null || y === null || z === null ? '' : `: ${metres(Math.hypot(x, y))} m in plan, ${metres(z)} m in height`;
  const isContradicted = 2 * (building.judged_area_m2 ?? 0) >= (building.area_m2 ?? Infinity) && (building.rms_m ?? 0) > mostRms_m;
  const text: Record<string, string> = {
    gone: 'The scan shows ground in its place.',
    changed: 'The scan shows another roof shape: too many points above it lie on none of its planes.',
    'faces missing': 'Too many points above it lie on none of its planes.',
    shifted: `The whole building is displaced${shift}.`,
    'too high': `The whole building is too high${shift}.`,
    'too low': `The whole building is too low${shift}.`,
    'wrong height': 'Most of its wrong area is too high or too low.',
    'wrong tilt': 'Most of its wrong area has another slope or direction.',
    'wrong outline': 'Most of its wrong area ends too far out or too far in.',
    'not judged': isContradicted ? `Its faces agree with the scan, but line ${building.worst_line} is ${metres(building.worst_distance_m)} m off.` : 'Less than half of its area has points.',
  };
  return text[building.verdict] ?? '';
}

/** The wrong buildings, those whose points are farthest off first. */
export function worstBuildings(buildings: readonly Building[]): Building[] {
  return buildings.filter((b) => b.verdict !== 'right' && b.verdict !== 'not judged').sort((a, b) => (b.points_rms_m ?? 0) - (a.points_rms_m ?? 0));
}
