set(io_matches_sources csv_table.cpp jpeg.cpp matches_file.cpp png_writer.cpp segments_file.cpp)
set(io_matches_headers csv_table.h jpeg.h matches_file.h png_writer.h segments_file.h)
