#include "../../../README.md"
