set(io_gates_sources gates_file.cpp nearest_name.cpp)
set(io_gates_headers gates_file.h nearest_name.h)
