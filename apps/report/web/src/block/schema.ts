// SPDX-License-Identifier: BSD-3-Clause
// The data written by apps/report/block/block_json.cpp. Lengths are in metres; plan coordinates are
// relative to `origin_m`.
import type { Report, Table2Row } from '../data/schema';

export type Box = [left: number, bottom: number, right: number, top: number];

/** The results of one method on a patch. */
export interface Figures {
  n_lines: number;
  n_evaluated: number;
  rms_m: number | null;
  median_m: number | null;
  max_m: number | null;
  n_reference_lines: number;
  n_reference_found: number;
}

export interface PatchRow {
  id: string;
  square: [column: number, row: number];
  core: Box;
  n_images: number;
  /** Why the patch has no lines; empty if it is finished. */
  reason: string;
  figures: Figures[]; // one per method
}

/** The smallest coordinates and the step lengths of 16-bit numbers. */
export type Steps = [x: number, y: number, dx: number, dy: number];

export interface PlanLines {
  n_all: number;
  n_shown: number;
  steps: Steps;
  ends: string;
  /** 65535: not judged. */
  distances_mm: string;
}

export interface WorstLine {
  id: string;
  patch: string;
  class: string;
  kind: string;
  status: string;
  length_m: number;
  mean_m: number | null;
  max_m: number | null;
  n_images: number;
}

/** LIDAR points; heights from low_m to high_m are mapped to greys from 0 to 255. */
export interface Relief {
  n_shown: number;
  steps: Steps;
  places: string;
  low_m: number;
  high_m: number;
  greys: string;
}

export interface BlockReport {
  schema: number;
  page: 'block';
  note: string;
  name: string;
  crs: string;
  origin_m: [number, number];
  patch_size_m: number;
  overlap_m: number;
  area: [number, number][];
  n_without_views: number;
  notes: string[];
  run: Report['run'];
  gates: Report['gates'];
  table2: Table2Row[];
  table2_footnote: string | null;
  methods: { name: string; lines: PlanLines; worst: WorstLine[] }[];
  patches: PatchRow[];
  points: (Relief & { n_read: number; n_all: number }) | null;
}

export type LineRow = [id: string, lineClass: string, kind: string, status: string, length_m: number, mean_m: number | null, max_m: number | null,
  nImages: number, x0: number, y0: number, z0: number, x1: number, y1: number, z1: number];

export interface PatchReport {
  schema: number;
  page: 'patch';
  note: string;
  block: string;
  id: string;
  crs: string;
  origin_m: [number, number];
  core: Box;
  area: Box;
  height_range_m: [number, number];
  images: string[];
  estimated_s: number;
  estimated_mib: number;
  reason: string;
  neighbours: Partial<Record<'north' | 'east' | 'south' | 'west', string>>;
  table2: Table2Row[];
  methods: { name: string; figures: Figures; lines: LineRow[] }[];
  points: Relief | null;
}
