set(evaluate_scan_sources
  scan/alpha_shape.cpp scan/border_line.cpp scan/borders.cpp scan/corners.cpp scan/edge_model.cpp scan/find_edges.cpp
  scan/grow_planes.cpp scan/neighbours.cpp scan/rims.cpp scan/roof_edge_extraction.cpp scan/scan_region.cpp scan/seams.cpp scan/surroundings.cpp scan/edge_kinds.cpp)
set(evaluate_scan_headers
  scan/alpha_shape.h scan/border_line.h scan/borders.h scan/corners.h scan/edge_kinds.h scan/edge_model.h scan/find_edges.h
  scan/grow_planes.h scan/neighbours.h scan/rims.h scan/roof_edge_extraction.h scan/scan_edges.h scan/scan_region.h scan/seams.h
  scan/surroundings.h)
