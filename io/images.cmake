set(io_image_sources image.cpp image_writer.cpp write_patch.cpp)
set(io_image_headers image.h image_writer.h write_patch.h)
