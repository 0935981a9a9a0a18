/// Takes the place of the system's dlclose in programs that are compiled for the leak sanitizer: a library
/// that has been loaded stays. Drivers of displays keep small blocks until the process ends; once such a
/// library is unloaded its blocks have no owner, and the places that made them no name to suppress them by.
extern "C" int dlclose(void* /*library*/) { return 0; }
