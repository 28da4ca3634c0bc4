// SPDX-License-Identifier: BSD-3-Clause
// The data written by apps/edges/edges_page.cpp. Lengths are in metres; plan coordinates are
// relative to `origin_m`.
export type Box = [left: number, bottom: number, right: number, top: number];

export interface KindRow {
  kind: string;
  n: number;
  length_m: number;
  median_sigma_m: number | null;
}

export type EdgeRow = [id: string, kind: string, x0: number, y0: number, x1: number, y1: number];

/** Slope and direction of descent in degrees, then the rings as x, y, x, y, ... */
export interface PlaneRow {
  slope_deg: number;
  aspect_deg: number | null;
  rings: number[][];
}

/** A section across the middle of an edge: t is the distance to the right, seen along the edge. */
export interface SectionRow {
  id: string;
  kind: string;
  length_m: number;
  support: number;
  sigma_m: number;
  moved_out_m: number;
  z: number; // of the middle of the edge
  points: [t: number, z: number][];
  planes: [t0: number, z0: number, t1: number, z1: number][];
}

export interface EdgesReport {
  schema: number;
  page: 'edges';
  name: string;
  crs: string;
  origin_m: [number, number];
  box: Box;
  n_edges: number;
  n_planes: number;
  kinds: KindRow[];
  edges: EdgeRow[];
  planes: PlaneRow[];
  sections: SectionRow[];
  half_width_m: number; // of the slab of a section
  notes: string[];
}
