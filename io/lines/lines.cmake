set(io_lines_sources
  attribute_table.cpp colmap.cpp geopackage_writer.cpp input_file.cpp patch.cpp yaml_check.cpp
  lines/attributes.cpp lines/csv_reader.cpp lines/geojson_reader.cpp lines/geojson_writer.cpp lines/geopackage_check.cpp lines/json_text.cpp
  lines/line_checks.cpp lines/line_facts.cpp lines/mesh_edges.cpp lines/obj_reader.cpp lines/ogr_reader.cpp
  lines/ogr_support.cpp lines/ogr_writer.cpp lines/ply_reader.cpp lines/polyline.cpp
  lines/read_lines.cpp lines/scratch_folder.cpp lines/sfm_lines_reader.cpp lines/text.cpp
  lines/text_writers.cpp lines/write_lines.cpp)
set(io_lines_headers attribute_table.h colmap.h geopackage_writer.h patch.h lines/line_facts.h lines/line_set.h lines/read_lines.h lines/write_lines.h)
