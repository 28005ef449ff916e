# %% [markdown]
# # Your own data
# From a file that a data logger wrote to numbers with error bars. The file is made here, so that the truth is known.

# %%
import numpy as np

import secular

rate, omega0, mu, stiffening = 200.0, 2 * np.pi * 5.0, 0.25, 4.0e6


def acceleration(x, v):
    return -omega0**2 * x - 2 * mu * v - stiffening * x**3


t = np.arange(3000) / rate
state, motion, step, parts = np.array([0.012, 0.0]), [], 1 / rate / 8, 8
for _ in t:  # classical Runge-Kutta, eight steps a sample
    motion.append(state[0])
    for _ in range(parts):
        slope = lambda s: np.array([s[1], acceleration(*s)])
        k1 = slope(state)
        k2 = slope(state + step / 2 * k1)
        k3 = slope(state + step / 2 * k2)
        k4 = slope(state + step * k3)
        state = state + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
measured = np.array(motion) + np.random.default_rng(5).normal(0, 2e-6, t.size)
np.savetxt("logger.csv", np.column_stack([t, 1e3 * measured]), delimiter=",", header="Time [s],Laser [mm]", comments="")

# %% [markdown]
# ## What is in the file, and a campaign of it

# %%
print(secular.inspect("logger.csv"))
made = secular.import_files("logger.csv", kind="free_decay", channels="x=Laser [mm]:response", time="Time [s]")
campaign = made.campaign
print(campaign, made.converted)
print(secular.spectrum(campaign, order=2))

# %% [markdown]
# ## A model, and its numbers

# %%
model = """
schema = 1
name   = "bracket"
[[mode]]
coordinate = "x"
frequency  = "omega0"
equation   = "D2(x) + omega0^2*x = -2*mu*D(x) - alpha*x^3"
[[case]]
name       = "free"
relations  = []
order      = { mu = 2, alpha = 2 }
expand_to  = 2
excitation = false
[nominal]
omega0 = 31.0
"""
result = secular.identify(campaign, model)
print(result)
figure = result.plot()

# %% [markdown]
# ## What follows: the backbone

# %%
prediction = secular.predict(model, result, case="free", largest=0.012)
backbone, = prediction.backbones
print(f"{backbone.frequency[0] / 2 / np.pi:.4f} Hz at rest, {backbone.frequency[-1] / 2 / np.pi:.4f} Hz at 12 mm")
backbone_figure = prediction.plot()
