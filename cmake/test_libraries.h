// libraries.h, and what tests include besides.
#pragma once

#include "libraries.h"

#include <gtest/gtest.h>
