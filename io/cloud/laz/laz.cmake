# LAZ and COPC, relative to io/: a library of its own that needs neither GDAL nor PROJ nor PCL.
ridgeline_module(laz
  SOURCES
    cloud/format_guess.cpp
    cloud/las_header.cpp
    cloud/las_vlr.cpp
    cloud/mapped_file.cpp
    cloud/page_advice.cpp
    cloud/laz/arithmetic_decoder.cpp
    cloud/laz/arithmetic_model.cpp
    cloud/laz/attribute_items.cpp
    cloud/laz/byte_stream.cpp
    cloud/laz/chunk_table.cpp
    cloud/laz/color.cpp
    cloud/laz/copc.cpp
    cloud/laz/damaged_chunk.cpp
    cloud/laz/gps_time.cpp
    cloud/laz/integer_decompressor.cpp
    cloud/laz/laszip_record.cpp
    cloud/laz/layered_items.cpp
    cloud/laz/laz_points.cpp
    cloud/laz/point10.cpp
    cloud/laz/point14.cpp
    cloud/laz/record_decoder.cpp
    cloud/laz/sequential_records.cpp
    cloud/laz/wave_packet.cpp
  HEADERS
    error.h
    cloud/bytes.h
    cloud/format_guess.h
    cloud/las_header.h
    cloud/las_vlr.h
    cloud/mapped_file.h
    cloud/page_advice.h
    cloud/laz/arithmetic_decoder.h
    cloud/laz/arithmetic_model.h
    cloud/laz/byte_stream.h
    cloud/laz/channel_contexts.h
    cloud/laz/chunk_table.h
    cloud/laz/codec_error.h
    cloud/laz/color.h
    cloud/laz/copc.h
    cloud/laz/damaged_chunk.h
    cloud/laz/gps_time.h
    cloud/laz/integer_decompressor.h
    cloud/laz/item_decoder.h
    cloud/laz/laszip_record.h
    cloud/laz/layered_items.h
    cloud/laz/laz_points.h
    cloud/laz/point14.h
    cloud/laz/record_decoder.h
    cloud/laz/record_parts.h
    cloud/laz/return_contexts.h
    cloud/laz/running_median.h
    cloud/laz/sequential_records.h
    cloud/laz/wave_packet.h
    cloud/laz/wrapping.h
  DEPENDS ridgeline::geometry
  PRIVATE_DEPENDS fmt::fmt Boost::headers)

list(APPEND io_cloud_sources cloud/laz/laz_source.cpp)
list(APPEND io_cloud_headers cloud/laz/laz_source.h)
