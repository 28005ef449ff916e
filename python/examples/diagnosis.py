# %% [markdown]
# # What does the model lack?
# A virtual test of a parametrically excited beam whose damping rises with speed, and a model with linear damping alone.

# %%
from pathlib import Path

import secular

model = """
schema = 1
name   = "beam"
[[mode]]
coordinate = "v"
frequency  = "omega0"
equation   = "D2(v) + omega0^2*v = -2*mu1*D(v) - alpha3*v^3 + eta2*F*v*cos(Omega*t)"
[[case]]
name      = "principal_parametric"
relations = ["Omega = 2*omega0 + eps^2*sigma"]
order     = { mu1 = 2, alpha3 = 2, eta2 = 2 }
expand_to = 2
[nominal]
omega0 = 77.85
"""
test = """
schema = 1
name   = "with_cubic_damping"
source = "made up"
model  = "beam.toml"
sample_rate_hz = 256.0
[parameters]
omega0 = 77.85
mu1    = 0.222
alpha3 = -2.83e7
eta2   = 7.65
[excitation]
name     = "base"
quantity = "acceleration"
unit     = "m/s^2"
noise_sd = 0.05
[[response]]
name     = "v"
quantity = "acceleration"
unit     = "m/s^2"
noise_sd = 0.05
[[effect]]
name     = "cubic_damping"
strength = 36.87
[[dwell]]
frequencies_hz = [24.6, 24.7, 24.8]
amplitudes = [18.0, 24.0]
ensembles = 4
ensemble_s = 4.0
settle_s = 90.0
initial_displacement = [1e-3]
"""
Path("beam.toml").write_text(model)
Path("damping.toml").write_text(test)
campaign = secular.simulate("damping.toml")

# %% [markdown]
# ## The gap, and what closes it

# %%
diagnosis = secular.diagnose(campaign, "beam.toml")
print(diagnosis)
print(f"{100 * diagnosis.closed:.1f} % of the gap is closed by {diagnosis.cause or diagnosis.causes_left}")
damping = diagnosis.causes[0]
print(f"{damping.effect}: {damping.symbol} = {damping.coefficient:.4f} +- {damping.sd:.4f}; 36.87 was simulated")
figure = diagnosis.plot()
