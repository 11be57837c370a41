// A context with a pbuffer into which tests draw vertices.
#pragma once

#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spangle/GL/gl.h>

#include "tests/support/headless_gl.hpp"

namespace spangle::test {

class Canvas : public testing::Test {
  protected:
    explicit Canvas(int side = size) : side_(side) {}
    static constexpr int size = 64; ///< width and height of most tests, in pixels

    void SetUp() override { current_.emplace(side_, side_); }
    void TearDown() override {
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        current_.reset();
    }

  private:
    int side_;
    std::optional<HeadlessGl> current_;
};

} // namespace spangle::test
