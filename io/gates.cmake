set(io_gates_sources gates_file.cpp)
set(io_gates_headers gates_file.h)
