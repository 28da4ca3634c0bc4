// SPDX-License-Identifier: BSD-3-Clause
// Okabe and Ito's colours, which colour-blind readers can distinguish; figure_colours.h has the
// same ones for the PNG figures. Nothing is shown by colour alone: classes also differ by dashes,
// statuses by words.
import type { Line } from './schema';

export const okabeIto = {
  black: '#000000',
  orange: '#e69f00',
  skyBlue: '#56b4e9',
  green: '#009e73',
  yellow: '#f0e442',
  blue: '#0072b2',
  vermillion: '#d55e00',
  purple: '#cc79a7',
  grey: '#969696',
} as const;

export const verdictColours = {
  correct: okabeIto.green,
  false: okabeIto.vermillion,
  missed: okabeIto.yellow,
  unsure: okabeIto.purple,
  unjudged: okabeIto.skyBlue,
} as const;

export const isDark = (): boolean => {
  const chosen = document.documentElement.dataset['theme'];
  return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
};

export function classColour(lineClass: string): string {
  if (lineClass === 'aligned') return okabeIto.vermillion;
  return isDark() ? okabeIto.skyBlue : okabeIto.blue;
}

const statusColours: Record<string, string> = {
  evaluated: okabeIto.green,
  no_lidar: okabeIto.grey,
  no_plane: okabeIto.orange,
  low_coverage: okabeIto.purple,
  ambiguous: okabeIto.yellow,
  degenerate: okabeIto.vermillion,
  unconfirmed: okabeIto.blue,
};
export const statusColour = (status: string): string => statusColours[status] ?? okabeIto.skyBlue;

/** Steps of the distance colours, metres; the last one has no limit. */
export const distanceSteps: readonly { upTo_m: number; colour: string; text: string }[] = [
  { upTo_m: 0.05, colour: okabeIto.blue, text: 'up to 0.05 m' },
  { upTo_m: 0.1, colour: okabeIto.skyBlue, text: 'up to 0.10 m' },
  { upTo_m: 0.3, colour: okabeIto.green, text: 'up to 0.30 m' },
  { upTo_m: 1, colour: okabeIto.orange, text: 'up to 1 m' },
  { upTo_m: Infinity, colour: okabeIto.vermillion, text: 'above 1 m' },
];

export function distanceColour(line: Line): string {
  const d = line.mean_distance_m;
  if (d === null) return okabeIto.grey;
  return distanceSteps.find((step) => d <= step.upTo_m)?.colour ?? okabeIto.grey;
}

/** The colour of the selection; no other line or plane has it. */
export const selectionColour = '#e6007e';

/** Colours of planes: neighbours in the list differ strongly, and the largest plane, usually the
 * ground, is grey. The colours are pale, so that no plane has the colour of a line;
 * write_results.cpp has the same ones. The deep palette is for small drawings on white. */
const planePalette = ['#b9b1a7', '#c3d3e3', '#e0cfae', '#c5d6b8', '#dfdcb4', '#bfc6dc', '#e0c4bd', '#d9c6d2'] as const;
const deepPalette = ['#8d857b', '#5f86ad', '#a88a4c', '#6f9356', '#9a9540', '#6470a3', '#ad6c5d', '#97718a'] as const;
export const planeColour = (index: number, deep = false): string => (deep ? deepPalette : planePalette)[index % planePalette.length]!;
export const noPlaneColour = (): string => (isDark() ? '#8a8d92' : '#c9c9c9');

/** The colour of a point of the surface, from the lowest (0) to the highest (1): violet, which no
 * plane or line has. */
export const surfaceColour = (height: number): string => `hsl(260, ${48 + 22 * height}%, ${58 + 20 * height}%)`;
