set(evaluate_matching_sources matching/match_scoring.cpp)
set(evaluate_matching_headers matching/match_scoring.h)
