#include "core/unfinished.h"

#include <gtest/gtest.h>

#include <optional>
#include <thread>

namespace rays {
namespace {

std::optional<double> an_unwritten_function() {
    unfinished("9.10");
    return {};
}
bool another() {
    unfinished("9.9");
    return {};
}

TEST(Unfinished, IsListedOnceInOrder) {
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(an_unwritten_function().has_value());
    std::thread([] { EXPECT_FALSE(another()); }).join();
    const auto tasks = unfinished_tasks();
    ASSERT_EQ(tasks.size(), 2u);
    EXPECT_EQ(tasks[0].task, "9.9");
    EXPECT_EQ(tasks[1].task, "9.10");  // not before 9.9, as text would sort it
    EXPECT_NE(tasks[0].file.find("unfinished_test.cpp"), std::string::npos);
    EXPECT_GT(tasks[0].line, 0u);
}

TEST(Unfinished, TheFirstTaskAskedForIsTakenOncePerThread) {
    take_unfinished_task();
    another();
    an_unwritten_function();
    EXPECT_STREQ(take_unfinished_task(), "9.9");
    EXPECT_EQ(take_unfinished_task(), nullptr);
}

}  // namespace
}  // namespace rays
