// SPDX-License-Identifier: BSD-3-Clause
import { okabeIto } from '../data/colours';

/** Colours of the kinds of roof edges; map_style.cpp has the same ones. */
const kindColours: Readonly<Record<string, string>> = {
  ridge: okabeIto.vermillion,
  hip: okabeIto.orange,
  valley: okabeIto.blue,
  eave: okabeIto.green,
  verge: okabeIto.skyBlue,
  step: okabeIto.purple,
};

export const kindColour = (kind: string): string => kindColours[kind] ?? okabeIto.grey;
