set(evaluate_statistics_sources
  compare/compare_folders.cpp compare/comparison.cpp compare/comparison_report.cpp compare/matcher_table.cpp
  compare/pair_in_space.cpp
  compare/wilcoxon.cpp
  gates/figure.cpp gates/gate.cpp gates/gate_report.cpp gates/gate_warnings.cpp gates/metric.cpp
  statistics/accuracy.cpp statistics/bootstrap.cpp statistics/calibration.cpp
  statistics/cloud_following.cpp statistics/compare_with_scan.cpp statistics/completeness.cpp
  statistics/constant_shift.cpp statistics/decoy_figures.cpp statistics/decoys.cpp
  statistics/distribution.cpp statistics/evaluation.cpp statistics/frame_check.cpp statistics/interval.cpp
  statistics/matching_quality.cpp statistics/parameter_intervals.cpp statistics/reference_errors.cpp
  tables/reference_table.cpp
  statistics/strata.cpp statistics/summary.cpp statistics/tolerance_measures.cpp
  tables/accuracy_table.cpp tables/area_json.cpp tables/cells.cpp tables/completeness_json.cpp
  tables/completeness_table.cpp tables/decoy_json.cpp tables/decoy_table.cpp
  tables/display_width.cpp tables/evaluation_json.cpp
  tables/evaluation_parse.cpp tables/format.cpp tables/line_csv.cpp tables/summary_json.cpp tables/table1.cpp
  tables/table2.cpp
  statistics/standards.cpp statistics/wireframe.cpp
  tables/shift_json.cpp tables/shift_text.cpp tables/standards_table.cpp tables/terminal_table.cpp tables/text_table.cpp
  tables/tolerance_table.cpp)
set(evaluate_statistics_headers
  compare/comparison.h compare/matcher_table.h compare/pair_in_space.h compare/wilcoxon.h
  gates/figure.h gates/gate.h gates/gate_report.h gates/gate_warnings.h gates/metric.h
  statistics/accuracy.h statistics/bootstrap.h statistics/calibration.h statistics/cloud_following.h
  statistics/compare_with_scan.h statistics/completeness.h
  statistics/constant_shift.h statistics/decided_group.h statistics/decoy_figures.h statistics/decoys.h
  statistics/distribution.h statistics/evaluation.h statistics/frame_check.h statistics/image_count.h statistics/product_method.h
  statistics/interval.h statistics/matching_quality.h statistics/parameter_intervals.h statistics/random.h
  statistics/reference_errors.h
  tables/reference_table.h
  statistics/strata.h statistics/summary.h statistics/tolerance_measures.h
  statistics/track_counts.h
  tables/accuracy_table.h tables/area_json.h tables/completeness_json.h tables/completeness_table.h tables/decoy_json.h tables/decoy_table.h tables/evaluation_json.h tables/format.h tables/result_folder.h tables/shift_json.h
  tables/shift_text.h tables/summary_json.h tables/table1.h tables/table2.h
  statistics/standards.h statistics/wireframe.h
  tables/standards_table.h tables/terminal_table.h tables/tolerance_table.h)
