#include <polhode/vec.hpp>

int main() { return 0; }
