set(evaluate_judge_sources
  judge/point_search.cpp judge/point_grid.cpp judge/ball_cover.cpp judge/footprint.cpp judge/image_evidence.cpp
  judge/plane_fit.cpp judge/plane_search.cpp judge/plane_sigma.cpp judge/plan_hull.cpp judge/judged_planes.cpp
  judge/roof_kind.cpp judge/ridge_displacement.cpp judge/plane_support.cpp judge/candidate_planes.cpp
  judge/ledge_search.cpp judge/plane_meeting.cpp judge/surface_hypotheses.cpp judge/surface_decision.cpp
  judge/segment_plane.cpp judge/judge_line.cpp judge/batch_judge.cpp judge/plane_ids.cpp judge/judge_lines.cpp
  judge/line_to_plane_evaluation.cpp judge/quiet_pcl.cpp)
set(evaluate_judge_headers
  judge/options.h judge/point_normals.h judge/point_search.h judge/point_grid.h judge/ball_cover.h
  judge/pcl_point_search.h judge/footprint.h judge/image_evidence.h judge/plane_fit.h judge/plane_search.h
  judge/plane_sigma.h judge/plan_hull.h judge/judged_planes.h judge/roof_kind.h judge/ridge_displacement.h
  judge/plane_support.h judge/zone_cells.h judge/candidate_planes.h judge/ledge_search.h
  judge/plane_meeting.h judge/surface_hypotheses.h judge/surface_weights.h judge/surface_decision.h judge/segment_plane.h
  judge/judge_line.h judge/batch_judge.h judge/plane_ids.h judge/judge_lines.h judge/line_to_plane_evaluation.h
  judge/quiet_pcl.h)
