// A structure in motion as SVG.
#include "report/structure_drawing.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <stdexcept>
#include <string>

#include "tests/report/well_formed.hpp"

namespace secular::report {
namespace {

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

StructureDrawing cantilever() {
  StructureDrawing drawing;
  drawing.title = "v1 & <tip>";
  drawing.id = "structure_v1";
  drawing.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  drawing.motion = {{}, {{{0, 0}, {0, 0}, {0.3, 0}}}, {{{0, 0}, {0, 0}, {1, 0}}}};
  drawing.lines = {{0, 1, 2}};
  return drawing;
}

TEST(StructureDrawing, ShowsBothEndsOfTheMotionAndMovesByItself) {
  const std::string svg = structure_drawing(cantilever());
  EXPECT_EQ(test::first_markup_error(svg), "");
  EXPECT_EQ(times(svg, "<circle"), 3u);
  EXPECT_EQ(times(svg, "<polyline"), 3u + 2u);  // rest, two ends; a stem for each point that moves
  EXPECT_EQ(times(svg, "<animate"), 1u + 2u);
  EXPECT_EQ(times(svg, "begin=\"structure_v1.click;structure_v1.keypress\""), 1u + 2u);
  EXPECT_EQ(times(svg, "<script"), 0u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  // One period: the first frame is the last one.
  const std::size_t begin = svg.rfind("values=\"") + 8, end = svg.find('"', begin);
  const std::string values = svg.substr(begin, end - begin);
  EXPECT_EQ(values.substr(0, values.find(';')), values.substr(values.rfind(';') + 1));
}

// What is drawn is the shape, whatever it is scaled by and whatever unit the points are in.
TEST(StructureDrawing, ScalesOfMotionAndLengthDoNotCount) {
  StructureDrawing other = cantilever();
  for (auto& motion : other.motion)
    for (std::complex<double>& part : motion) part *= 0x1p-23;
  for (auto& point : other.points)
    for (double& part : point) part *= 1024;
  EXPECT_EQ(structure_drawing(other), structure_drawing(cantilever()));
}

TEST(StructureDrawing, NothingMovesOrOnePointIsDrawnToo) {
  StructureDrawing still = cantilever();
  for (auto& motion : still.motion) motion = {};
  EXPECT_EQ(structure_drawing(still).find("nan"), std::string::npos);
  StructureDrawing one;
  one.title = "one";
  one.id = "one";
  one.points = {{3, 2, 1}};
  one.motion = {{{{0, 1}, {0, 0}, {1, 0}}}};
  const std::string svg = structure_drawing(one);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  one.lines = {{0, 1}};
  EXPECT_THROW(structure_drawing(one), std::invalid_argument);
  EXPECT_THROW(structure_drawing({}), std::invalid_argument);
  StructureDrawing dashed = cantilever();
  dashed.id = "structure-v1";  // SMIL: at structure, v1.click earlier
  EXPECT_THROW(structure_drawing(dashed), std::invalid_argument);
}

}  // namespace
}  // namespace secular::report
