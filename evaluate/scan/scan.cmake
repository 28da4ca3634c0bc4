set(evaluate_scan_sources
  scan/find_edges.cpp)
set(evaluate_scan_headers
  scan/find_edges.h scan/scan_edges.h)
