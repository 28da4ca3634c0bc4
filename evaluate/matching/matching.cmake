set(evaluate_matching_sources matching/match_scoring.cpp matching/on_edge.cpp matching/track_scoring.cpp)
set(evaluate_matching_headers matching/match_scoring.h matching/on_edge.h matching/track_scoring.h)
