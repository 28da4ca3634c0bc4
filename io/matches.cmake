set(io_matches_sources csv_table.cpp encoded_picture.cpp matches_file.cpp png_writer.cpp segments_file.cpp)
set(io_matches_headers csv_table.h encoded_picture.h matches_file.h png_writer.h segments_file.h)
