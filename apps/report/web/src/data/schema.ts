// SPDX-License-Identifier: BSD-3-Clause
// The data written by apps/report/report_json.cpp. Lengths are in metres, coordinates relative to
// the patch's origin, image coordinates in pixels with (0, 0) in the centre of the top-left pixel.

export type Triple = [number, number, number];
export type ImageSegment = [number, number, number, number];
export type Verdict = 'correct' | 'false' | 'unjudged';

export interface Summary {
  n_lines: number;
  n_evaluated: number;
  n_excluded: Record<string, number>;
  evaluated_share: number | null;
  rms_m: number | null;
  ci95_m: [number, number] | null;
  n_clusters: number;
  few_clusters: boolean;
  rms_length_weighted_m: number | null;
  mean_m: number | null;
  std_m: number | null;
  median_m: number | null;
  nmad_m: number | null;
  q683_m: number | null;
  q90_m: number | null;
  q95_m: number | null;
  max_m: number | null;
  max_id: string;
  gross_share: number | null;
  n_outliers: number;
  rms_without_outliers_m: number | null;
  /** How many of the lines farthest off contribute half of the sum of squares, and the RMS of the
   * others; missing in tables of older versions. */
  n_half_of_squares?: number;
  rms_without_half_m?: number | null;
  /** Number of ridges and hips with horizontal and vertical parts. */
  n_parts: number;
  rmse_horizontal_m: number | null;
  rmse_vertical_m: number | null;
  mean_vertical_m: number | null;
}

/** The figures of all judged lines of a class; tables of older versions have no `decided_by`. */
export interface ClassSummary extends Summary {
  decided_by?: { plan_images: Summary; points_place: Summary };
}

export interface Table2Row extends ClassSummary {
  patch: string;
  method: string;
  class: string;
}

export interface Table1Row {
  patch: string;
  matcher: string;
  correct: number;
  false: number;
  missed: number;
  unjudged: number;
  correctness: number | null;
  completeness: number | null;
  quality: number | null;
  correctness_ci95: [number, number] | null;
  completeness_ci95: [number, number] | null;
  quality_ci95: [number, number] | null;
}

/** Tracks compared with the true edges of a class that `n_images` images show; null: all edges. */
export interface TrackCell {
  class: string;
  n_images: number | null;
  edges: number;
  edges_found: number;
  edge_recall: number | null;
  observation_recall: number | null;
  right: number;
  wrong: number;
  observation_precision: number | null;
}

export interface PatchTracks {
  patch: string;
  cells: TrackCell[];
}

export interface Accuracy {
  n: number;
  observed_m: number | null;
  product_m: number | null;
  method_only_m: number | null;
  sigma_ref_m: number | null;
  extrapolated_share: number | null;
  flags: string[];
}

export interface Calibration {
  n: number;
  nees_per_dof: number | null;
  bounds95: [number, number] | null;
  median_z2: number | null;
  coverage_1_96: number | null;
  share_beyond_99_9: number | null;
  median_sigma_m: number | null;
}

export interface IsoMeasure {
  id: number;
  name: string;
  value: number | null;
  unit: string;
  n: number;
}

/** The figures of one class as defined by standards. */
export interface Standards {
  asprs: {
    n: number;
    rmse_horizontal_m: number | null;
    rmse_vertical_m: number | null;
    rmse_3d_m: number | null;
    best_class_m: number | null;
    few_checkpoints: boolean;
    biased: boolean;
  };
  nssda: { horizontal_m: number | null; vertical_m: number | null };
  uncertainty: {
    laser_random_m: number | null;
    laser_systematic_m: number | null;
    plane_fit_m: number | null;
    combined_m: number | null;
    expanded_m: number | null;
    k: number;
    sampling_m: number | null;
  };
  iso19157: IsoMeasure[];
}

export interface Stratum extends Summary {
  stratum: string;
  calibration: Calibration;
}

export interface LinePlane {
  id: number;
  n_inliers: number;
  rms_m: number | null;
  coverage: number | null;
  extrapolation_m: number | null;
  start_distance_m: number | null;
  end_distance_m: number | null;
  mean_distance_m: number | null;
}

/** Image, number of the segment in it, and its ends as used to reconstruct the line. */
export type LineObservation = [view: number, segment: number | null, px: ImageSegment | null];

/** The words are explained in apps/report/line_views.h. */
export type ViewState = 'agrees' | 'differs' | 'sighted' | 'missing' | 'hidden' | 'border' | 'not_used';
export type LineInView = [state: ViewState, offset_px?: number, sigma_px?: number];

export interface Line {
  id: string;
  class: string;
  building?: string;
  status: string;
  kind: string | null;
  reason?: string;
  flags: string[];
  /** The surface that it is assumed to bound, the second most probable one, and the deciding
   * evidence; null if unknown. */
  surface?: string | null;
  surface_other?: string | null;
  surface_probability?: number | null;
  decided_by?: string | null;
  length_m: number | null;
  epipolar_angle_deg: number | null;
  planes: LinePlane[];
  mean_distance_m: number | null;
  max_distance_m: number | null;
  signed_mean_m: number | null;
  sigma_plane_m: number | null;
  sigma_line_m: number | null;
  z: number | null;
  displacement?: { horizontal_m: number; vertical_m: number; covariance_m2: [[number, number], [number, number]] } | null;
  height_if_vertical_m?: number | null;
  /** Its position when it was judged. */
  start?: Triple;
  end?: Triple;
  /** Its position in the images, if it was moved before it was judged. */
  seen_start?: Triple;
  seen_end?: Triple;
  /** Its image segments; the first two are from the pair in which it was found. */
  observations?: LineObservation[];
  /** With three or more images, how it appears in each image; null for an image that does not
   * contain it. */
  views?: (LineInView | null)[];
  construction?: string;
  n_points?: number;
  n_images?: number;
  true_error_m?: number | null;
}

export interface Plane {
  id: number;
  normal: Triple;
  n_inliers: number;
  rms_m: number;
  outline: Triple[];
}

/** A row of buildings.csv. Heights are model minus scan. */
export interface Building {
  id: string;
  verdict: string;
  n_lines: number;
  n_judged_lines: number;
  rms_m: number | null;
  worst_line: string;
  worst_distance_m: number | null;
  n_faces: number;
  n_judged_faces: number;
  ridge_height_m: number | null;
  eave_height_m: number | null;
  unexplained_share: number | null;
  shift_x_m: number | null;
  shift_y_m: number | null;
  shift_z_m: number | null;
  points_rms_m: number | null;
  points_p90_m: number | null;
  area_m2: number | null;
  judged_area_m2: number | null;
}

/** A row of to_fix.csv: a wrong line or building, with the gain from correcting it. */
export interface ToFix {
  what: 'line' | 'building';
  id: string;
  building: string;
  kind: string;
  gain_share: number;
  off_m: number | null;
  move_x_m: number | null;
  move_y_m: number | null;
  move_z_m: number | null;
}

/** Deliberately moved lines, by kind and distance: how many of them pass as correct. */
export interface DecoyFigure {
  kind: string;
  distance_m: number;
  n_lines: number;
  n_decoys: number;
  share: number | null;
  ci95: [number, number] | null;
  withheld_share: number | null;
}

/** Edges of the scan of a kind and length. */
export interface CompletenessRow {
  kind: string;
  length: string;
  n: number;
  recall: number | null;
  ci95: [number, number] | null;
  recall_length: number | null;
  n_not_in_images: number;
}

/** Which edges of the scan the lines have found. */
export interface Completeness {
  area_from: string;
  area_m2: number;
  n_lines: number;
  n_lines_without_edge: number;
  rows: CompletenessRow[];
}

export interface Method {
  name: string;
  options: { gross_m: number; [key: string]: unknown };
  summary: Record<string, ClassSummary>;
  accuracy: Record<string, Accuracy>;
  calibration: Calibration;
  strata: Record<string, Stratum[]>;
  /** The figures by class. */
  standards?: Record<string, Standards>;
  /** Empty if no lines were moved. */
  decoys?: DecoyFigure[];
  /** Only if the lines were compared with the edges of the scan. */
  completeness?: Completeness;
  lines: Line[];
  planes: Plane[];
  plane_of_point: string;
  /** Only for a building model. */
  buildings?: Building[];
  to_fix?: ToFix[];
}

/** Focal lengths and principal point in pixels of the file, then k1, k2, k3, p1, p2. */
export type Lens = [number, number, number, number, number, number, number, number, number];

export interface View {
  id: string;
  file: string;
  width_px: number;
  height_px: number;
  /** Column and row of the first pixel in the file, of which only a window may have been read. */
  corner_px: [number, number];
  /** Null for a lens without distortion. */
  lens: Lens | null;
  projection: number[];
  segments: string;
  /** For each other image: one bit per segment, whether it is aligned with its epipolar line. */
  aligned: string[];
  jpeg: string;
}

export interface Match {
  left: number;
  right: number;
  /** From the matcher; a match derived from a track has none. */
  score?: number;
  votes?: number;
  verdict?: Verdict;
}

/** `left` of a match is a segment of `base`, `right` one of `search`. */
export interface PairOfViews {
  base: number;
  search: number;
  matches: Match[];
  missed: [number, number][];
}

export interface Images {
  views: View[];
  max_aligned_angle_deg: number;
  /** Whether the first pair has reference matches. */
  has_reference: boolean;
  /** The pairs that were matched, the base pair first. */
  pairs: PairOfViews[];
  /** With three or more images: image, segment, image, segment, ... for each edge. */
  tracks: number[][];
  n_unmatched: Record<string, number>;
}

export interface PointSet {
  n_shown: number;
  low: Triple;
  step: Triple;
  positions: string;
}

/** Points of the cloud against which lines were judged. */
export interface Points extends PointSet {
  n_read: number;
  n_all: number;
  per_m2: number;
  /** Null if only the surroundings of lines were read. */
  no_data_share: number | null;
}

export interface Patch {
  id: string;
  folder: string;
  crs: string;
  origin_m: Triple;
  notes: string[];
  images: Images | null;
  points: Points | null;
  /** The points that dense matching of the two images found. */
  surface: PointSet | null;
  methods: Method[];
  /** Index of the method or line file whose lines are the product of the run; the others are
   * baselines and never shown first. */
  product: number;
}

export interface GateResult {
  rule: string;
  patch: string;
  method: string;
  class: string;
  metric: string;
  value: number | null;
  limit: number | null;
  baseline: number | null;
  n: number;
  verdict: string;
  explanation?: string;
}

/** An area, and the figures of its lines (of the first line file). */
export interface JudgedArea {
  /** x_min, y_min, x_max, y_max. */
  bounds_m: [number, number, number, number];
  /** Its page, relative to this one; absent if it had none. */
  page?: string;
  n_lines: number;
  n_evaluated: number;
  rms_m: number | null;
}

export interface Report {
  schema: number;
  note: string;
  run: {
    command?: string;
    /** Texts of the operator for the top of the page. */
    page?: { title?: string; project?: string; operator?: string; date?: string };
    versions?: Record<string, string>;
    options?: Record<string, unknown>;
    inputs?: { role: string; path: string; bytes: number; sha256: string }[];
    warnings?: string[];
    /** Sentences about the outcome of the whole run that its tables do not show. */
    messages?: string[];
    /** Only for pooled results: the areas in which the lines were judged. */
    areas?: JudgedArea[];
  };
  gates: { passed: boolean; gates: GateResult[]; warnings: string[] } | null;
  table1: Table1Row[];
  /** Only with reference tracks. */
  table1_tracks?: PatchTracks[];
  table2: Table2Row[];
  /** Why direct and joint differ on not_aligned lines, if they do so by design. */
  table2_footnote: string | null;
  patches: Patch[];
}
