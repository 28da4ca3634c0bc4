set(io_image_sources image.cpp segments_file.cpp image_writer.cpp write_patch.cpp)
set(io_image_headers image.h segments_file.h image_writer.h write_patch.h)
