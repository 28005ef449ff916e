#include "codegen/document/look_alikes.hpp"

#include <map>
#include <set>
#include <string>

#include "codegen/document/latex_math.hpp"

namespace secular::typeset {
namespace {

template <typename Visit>
void visit_symbols(Expression& formula, const Visit& visit) {
  if (formula.kind == Expression::Kind::symbol) visit(formula);
  for (Expression& part : formula.parts) visit_symbols(part, visit);
}

template <typename Visit>
struct BlockVisitor {
  const Visit& visit;
  void operator()(Heading&) const {}
  void operator()(Paragraph& paragraph) const {
    for (Run& run : paragraph.runs)
      if (Expression* formula = std::get_if<Expression>(&run)) visit_symbols(*formula, visit);
  }
  void operator()(EquationList& list) const {
    for (Equation& equation : list.equations) {
      visit_symbols(equation.left, visit);
      visit_symbols(equation.right, visit);
    }
  }
  void operator()(Table& table) const {
    for (std::vector<Expression>& row : table.rows)
      for (Expression& cell : row) visit_symbols(cell, visit);
  }
};

template <typename Visit>
void visit_symbols(Document& document, const Visit& visit) {
  for (Block& block : document.blocks) std::visit(BlockVisitor<Visit>{visit}, block);
}

}  // namespace

void tell_look_alikes_apart(Document& document) {
  std::map<std::string, std::set<std::string>> identifiers_by_look;
  visit_symbols(document,
                [&](Expression& symbol) { identifiers_by_look[latex_symbol(symbol.text)].insert(symbol.text); });
  visit_symbols(document, [&](Expression& symbol) {
    symbol.verbatim = identifiers_by_look.at(latex_symbol(symbol.text)).size() > 1;
  });
}

}  // namespace secular::typeset
