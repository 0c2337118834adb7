// rays-report RESULTS.json OUT.html
#include <cstdio>
#include <exception>

#include "core/error.h"
#include "report.h"

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: rays-report RESULTS.json OUT.html\n");
        return rays::kBadInput;
    }
    try {
        rays::write_report(argv[1], argv[2]);
        return rays::kSuccess;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "rays-report: %s\n", e.what());
        return rays::kBadInput;
    }
}
