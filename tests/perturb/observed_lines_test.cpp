// One line of the response is one equation, whatever combinations of frequencies make it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "perturb/lump_equations.hpp"
#include "perturb/model.hpp"
#include "tests/perturb/textbook_models.hpp"

namespace secular {
namespace {

using Row = std::vector<GiNaC::numeric>;

Row negative(Row row) {
  for (GiNaC::numeric& x : row) x = -x;
  return row;
}

// Under hard excitation near three times the natural frequency the response has the odd and, by the quadratic term,
// the even multiples of a third of the excitation's.
LumpEquations of_subharmonic(const std::string& nominal) {
  const Model model =
      read_model_text(textbook::one_mode("D2(x) + w^2*x = -2*mu*D(x) - a2*x^2 - a3*x^3 + e*F*cos(Omega*t)",
                                         "relations = [\"Omega = 3*w + eps*sigma\"]\norder = { mu = 1, a2 = 1, a3 "
                                         "= 1, e = 0 }\nexpand_to = 1\n" +
                                             nominal),
                      "model.toml");
  FractionSums sums(model.symbols.with_pi());
  return lump_equations(derive(model, model.find_case("c")), derive(model, model.find_case("c"), OmegaPolicy::kept),
                        sums);
}

TEST(ObservedLines, AConjugateIsNoLineOfItsOwn) {
  for (const std::string nominal : {"", "[nominal]\nw = 10.0\n"}) {
    const LumpEquations seen = of_subharmonic(nominal);
    std::vector<Row> lines;
    for (const LumpEquation& block : seen.blocks) {
      if (block.modulation) continue;
      lines.push_back(seen.frequencies.of_phase(block.phase));
      for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        EXPECT_NE(lines[i], lines.back());
        EXPECT_NE(negative(lines[i]), lines.back()) << nominal << ": line " << i << " counted again";
      }
    }
    // 0, 2, 3, 4, 5, 6, 7 and 9 thirds of the excitation frequency; 1 is the oscillation itself, and 8 is of a
    // higher order.
    EXPECT_EQ(lines.size(), 8U) << nominal;
  }
}

}  // namespace
}  // namespace secular
