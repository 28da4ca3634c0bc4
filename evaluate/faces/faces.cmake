set(evaluate_faces_sources
  faces/building_table.cpp faces/covered_share.cpp faces/edge_heights.cpp faces/face_evaluation.cpp faces/face_plane.cpp
  faces/face_points.cpp faces/face_table.cpp faces/judge_face.cpp faces/judge_faces.cpp faces/outline.cpp
  faces/plan_polygon.cpp faces/plane_difference.cpp faces/point_distances.cpp faces/roof_face.cpp faces/whole_shift.cpp)
set(evaluate_faces_headers
  faces/building_table.h faces/covered_share.h faces/edge_heights.h faces/face_evaluation.h faces/face_plane.h
  faces/face_points.h faces/face_table.h faces/judge_face.h faces/judge_faces.h faces/neighbour_face.h faces/limits.h
  faces/outline.h faces/overhang.h faces/plan_polygon.h faces/plane_difference.h faces/point_distances.h faces/roof_face.h faces/whole_shift.h)
