set(evaluate_scan_sources
  scan/edge_kinds.cpp scan/find_edges.cpp)
set(evaluate_scan_headers
  scan/edge_kinds.h scan/find_edges.h scan/scan_edges.h)
