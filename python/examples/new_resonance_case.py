# %% [markdown]
# # A new resonance case
# A model holds the physics once; a resonance that is excited is one [[case]] block (docs/new_resonance_case.md).

# %%
import secular

physics = """
schema = 1
name   = "my_beam"
[[mode]]
coordinate = "v"
frequency  = "omega0"
equation   = "D2(v) + omega0^2*v = -2*mu*D(v) - alpha*v^3 + eta*F*cos(Omega*t)"
"""
primary = """
[[case]]
name      = "primary"
relations = ["Omega = omega0 + eps^2*sigma"]
order     = { mu = 2, alpha = 2, eta = 2 }
expand_to = 2
"""
superharmonic = """
[[case]]
name      = "a_third"
relations = ["3*Omega = omega0 + eps*sigma"]
order     = { mu = 1, alpha = 1, eta = 0 }
expand_to = 1
"""

# %% [markdown]
# ## Derive it; the certificate says whether the expansion solves the equation of motion

# %%
derivation = secular.derive(physics + primary + superharmonic, "a_third")
print(derivation.text[:1500])
assert derivation.certified

# %% [markdown]
# ## Numbers of its coefficients

# %%
values = {"omega0": 77.85, "mu": 0.2, "alpha": 5e6, "eta": 1.0, "sigma": 0.0, "F": 40.0}
numbers = secular.evaluate(physics + superharmonic, "a_third", values)
print(numbers)

# %% [markdown]
# ## The response that it predicts, over the excitation's frequency near a third of the natural one

# %%
beam = {name: values[name] for name in ("omega0", "mu", "alpha", "eta")}
response = secular.predict(physics + superharmonic, beam, at={"F": 40.0}, vary=("Omega", 4.12, 4.18), hz=True)
print(response)
figure = response.plot("response")

# %% [markdown]
# ## The dwells that would determine it

# %%
plan = secular.plan(physics + superharmonic, beam, "mu", frequency_hz=(4.12, 4.18), amplitude=(20, 40), budget_s=1200,
                    frequencies=8, levels=2)
print(plan)
