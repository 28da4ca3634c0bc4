# SPDX-License-Identifier: BSD-3-Clause
"""Fits the weights of evaluate/judge/surface_weights.h to what dump_hypotheses prints.

    dump_hypotheses 5 0.4 village 1 2 3 > a.txt
    python3 fit_weights.py a.txt ...

Conditional logistic regression: each line of a scene has hypotheses, one or more of which are
right. Needs NumPy and SciPy.
"""
import sys

import numpy as np
from scipy.optimize import minimize

N_PLAN = 30  # kNumPlanTerms
PLACE_SIGMA_M = 0.3
WRONG_DENSITY_PER_M = 0.002
WRONG_SHARE, N_WRONG, FARTHEST_M = 0.1, 2, 8.0  # of each line's weight, at so many heights up to so far off
RIGHT_M = 0.25
FARTHEST_OBJECT_M = 1.8
RIDGE = 0.02  # of the prior, which keeps weights of rare terms small
WEIGHT = {"foot": 0.2, "ground": 0.4}
WEIGHT_WITHOUT_PLANE = 0.3  # times that of the kind: an edge that no candidate belongs to
WEIGHT_OF_OBJECT, WEIGHT_OF_OBJECT_WITHOUT_PLANE = 0.01, 0.005


class Line:
    def __init__(self, kind, n_planes, surfaces, rows):
        self.kind = kind
        self.is_object = np.array([s == "object" for s in surfaces])
        self.off_m, self.signed_m, self.normal_z, self.sigma_m = rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3]
        self.terms = rows[:, 4:4 + N_PLAN + 1]
        self.has_plane = np.isfinite(rows[:, 4 + N_PLAN + 1])
        passes = (self.off_m <= RIGHT_M) & self.has_plane
        self.has_surface = bool((passes & ~self.is_object).any())
        self.right = passes & ~self.is_object if self.has_surface else self.is_object
        of_its_kind = self.right & (np.array([s == "ridge" for s in surfaces]) == (n_planes == 2))
        if of_its_kind.any():
            self.right = of_its_kind

    def log_place(self, by_m):
        """Of the hypotheses of the line moved in height by `by_m`, as log_place() of
        surface_decision.cpp.
        """
        signed_m = self.signed_m + by_m * self.normal_z
        right = PLACE_SIGMA_M * np.sqrt(2.0 * np.pi)
        wrong = WRONG_DENSITY_PER_M * right
        scaled = np.minimum(np.abs(signed_m) / np.hypot(PLACE_SIGMA_M, self.sigma_m), 50.0)
        stands = ((np.abs(signed_m) < FARTHEST_OBJECT_M) & self.has_plane).any()
        stands |= by_m == 0.0 and self.terms[:, N_PLAN].max() > 0.0
        of_object = right / (2.0 * FARTHEST_OBJECT_M) if stands else wrong * wrong
        return np.log(np.where(self.has_plane, np.exp(-0.5 * scaled ** 2) + wrong, of_object))

    def weight(self):
        if self.kind == "object":
            return WEIGHT_OF_OBJECT if self.has_surface else WEIGHT_OF_OBJECT_WITHOUT_PLANE
        return WEIGHT.get(self.kind, 1.0) * (1.0 if self.has_surface else WEIGHT_WITHOUT_PLANE)


def read(paths):
    groups = {}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for row in file:
                fields = row.split()
                _, _, surfaces, rows = groups.setdefault((path, fields[0]), (fields[1], int(fields[3]), [], []))
                surfaces.append(fields[4])
                rows.append([float(v) for v in fields[5:]])
    return [Line(kind, n_planes, surfaces, np.array(rows)) for kind, n_planes, surfaces, rows in groups.values()]


def cases(lines, random):
    """Terms, place, right hypotheses, number of the case of each hypothesis; weight of each case.
    """
    terms, place, right, case, weights = [], [], [], [], []
    for line in lines:
        moves = [(0.0, 1.0 - WRONG_SHARE)]
        moves += [(random.uniform(-FARTHEST_M, FARTHEST_M), WRONG_SHARE / N_WRONG) for _ in range(N_WRONG)]
        for by_m, share in moves:
            x = line.terms.copy()
            if by_m != 0.0:
                x[:, N_PLAN] = 0.0  # no points accompany the moved line
            terms.append(x)
            place.append(line.log_place(by_m))
            right.append(line.right)
            case.append(np.full(len(x), len(weights)))
            weights.append(share * line.weight())
    return np.vstack(terms), np.concatenate(place), np.concatenate(right), np.concatenate(case), np.array(weights)


def fit(lines):
    terms, place, right, case, weights = cases(lines, np.random.default_rng(1))
    n = len(weights)

    def loss(w):
        score = terms @ w + place
        most = np.full(n, -np.inf)
        np.maximum.at(most, case, score)
        likelihood = np.exp(score - most[case])
        all_sum = np.bincount(case, likelihood, n)
        right_sum = np.maximum(np.bincount(case, likelihood * right, n), 1e-300)
        slope = (likelihood / all_sum[case] - likelihood * right / right_sum[case]) * weights[case]
        value = (weights * (np.log(all_sum) - np.log(right_sum))).sum() + RIDGE * (w ** 2).sum()
        return value, terms.T @ slope + 2.0 * RIDGE * w

    return minimize(loss, np.zeros(N_PLAN + 1), jac=True, method="L-BFGS-B", options={"maxiter": 2000}).x


if __name__ == "__main__":
    for weight in fit(read(sys.argv[1:])):
        print(f"{weight:.2f}")
