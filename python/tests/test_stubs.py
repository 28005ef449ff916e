"""The stub of the extension module says what the module has."""
import ast
import inspect
import re
from pathlib import Path

import secular
from secular import _core


def stub():
    return ast.parse((Path(secular.__file__).parent / "_core.pyi").read_text(encoding="utf-8"))


def arguments(function: ast.FunctionDef) -> list:
    return [argument.arg for argument in function.args.args]


def signature(function) -> list:
    """Names of a bound function's arguments, from the first line of its documentation."""
    text = re.match(r"\w+\((.*)\) -> ", function.__doc__)[1]
    return re.findall(r"(?:^|, )(\w+): ", text)


def test_every_name_is_in_the_stub_and_every_name_of_it_in_the_module():
    declared = {node.name for node in stub().body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    declared |= {node.target.id for node in stub().body if isinstance(node, ast.AnnAssign)}
    assert declared == {name for name in dir(_core) if not name.startswith("_")}


def test_functions_and_methods_take_what_the_stub_says():
    for node in stub().body:
        if isinstance(node, ast.FunctionDef):
            assert signature(getattr(_core, node.name)) == arguments(node), node.name
        if not isinstance(node, ast.ClassDef):
            continue
        bound = getattr(_core, node.name)
        members = {item.name: item for item in node.body if isinstance(item, ast.FunctionDef)}
        assert set(members) == {name for name in vars(bound) if not name.startswith("_")}, node.name
        for name, item in members.items():
            marks = [mark.id for mark in item.decorator_list]
            kind = inspect.getattr_static(bound, name)
            assert ("property" in marks) == isinstance(kind, property), name
            if isinstance(kind, property):
                continue
            given = signature(getattr(bound, name))
            expected = arguments(item) if "staticmethod" in marks else arguments(item)[1:]
            assert [each for each in given if each not in ("self", "arg0")] == expected or \
                len([each for each in given if each != "self"]) == len(expected), name


def test_what_the_package_shows_is_there_and_explained():
    for name in secular.__all__:
        shown = getattr(secular, name)
        assert shown.__doc__ and not shown.__doc__.startswith(f"{name}("), name
        if inspect.isfunction(shown):
            assert all(p.annotation is not p.empty for p in inspect.signature(shown).parameters.values()), name


def test_results_are_tables_in_a_notebook_and_figures():
    from secular._result import Result

    results = [getattr(secular, name) for name in secular.__all__]
    results = [shown for shown in results if inspect.isclass(shown) and issubclass(shown, Result)]
    assert len(results) >= 8
    for shown in results:
        for method in ("to_json", "to_pandas", "_repr_html_"):
            assert callable(getattr(shown, method)) and (method[0] == "_" or getattr(shown, method).__doc__), shown
        assert shown.__repr__ is not object.__repr__, shown
        # docs/python.md says which have none: terms of an evaluation, and files that become a campaign.
        assert hasattr(shown, "plot") != (shown in (secular.Evaluation, secular.Import)), shown
    assert callable(secular.Campaign._repr_html_)


def test_methods_that_classes_name_exist():
    named = 0
    for shown in (getattr(secular, name) for name in secular.__all__):
        if inspect.isclass(shown):
            for method in re.findall(r"(?<![\w.])(\w+)\(\)", shown.__doc__):
                assert hasattr(shown, method), f"{shown.__name__}.{method}"
                named += 1
    assert named >= 3
