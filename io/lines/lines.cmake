set(io_lines_sources
  attribute_table.cpp colmap.cpp geopackage_writer.cpp input_file.cpp patch.cpp utf8.cpp yaml_check.cpp
  kinds/folder_kind.cpp kinds/recognise.cpp kinds/text_kind.cpp kinds/top_keys.cpp
  lines/attributes.cpp lines/csv_reader.cpp lines/dxf_header.cpp lines/feature_collector.cpp lines/geojson_reader.cpp lines/geojson_writer.cpp lines/geopackage_check.cpp lines/json_text.cpp lines/kind_counts.cpp
  lines/line_checks.cpp lines/line_facts.cpp lines/mesh_edges.cpp lines/obj_reader.cpp lines/ogr_reader.cpp
  lines/ogr_support.cpp lines/ogr_writer.cpp lines/ply_reader.cpp lines/polyline.cpp
  lines/read_lines.cpp lines/scratch_folder.cpp lines/sfm_lines_reader.cpp lines/straight_vertices.cpp lines/text.cpp
  lines/text_writers.cpp lines/unique_ids.cpp lines/wkt.cpp lines/write_lines.cpp)
set(io_lines_headers attribute_table.h colmap.h geopackage_writer.h kinds/folder_kind.h kinds/recognise.h patch.h lines/line_facts.h lines/kind_counts.h lines/line_set.h lines/read_lines.h lines/write_lines.h)
