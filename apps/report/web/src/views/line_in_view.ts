// SPDX-License-Identifier: BSD-3-Clause
// Describes in words how a line appears in an image. Patches of two images have no descriptions:
// both images show every line.
import type { Line, Patch } from '../data/schema';
import { fixed } from '../ui/format';
import type { PatchImages } from './patch_images';

export interface ViewWords {
  /** One or two words, to be read first. */
  word: string;
  more: string;
  /** Whether the image contradicts the line. */
  disagrees: boolean;
}

/** Null if nothing is known. */
export function viewWords(patch: Patch, line: Line, view: number): ViewWords | null {
  const shown = line.views?.[view];
  if (!shown) return null;
  const [state, offset_px, sigma_px] = shown;
  const off = offset_px === undefined ? '' : `${fixed(offset_px, 2)} px off, sigma ${fixed(sigma_px, 2)} px`;
  const say = (word: string, more: string, disagrees = false): ViewWords => ({ word, more, disagrees });
  switch (state) {
    case 'agrees': return say('agrees', off);
    case 'differs': return say('differs', off, true);
    case 'sighted': return say('shows it', '');
    case 'missing': return patch.surface ? say('missing', 'it should show the line', true) : say('no segment', 'the occluding surface is unknown');
    case 'hidden': return say('hidden', 'by an object in front');
    case 'border': return say('no segment', 'partly outside');
    case 'not_used': return say('not used', '');
  }
}

/** One sentence about all images of a line; null for patches of two images. */
export function sentenceOfViews(patch: Patch, line: Line, images: PatchImages): string | null {
  if (!line.views || !images.areSeveral) return null;
  const named = (word: string): string[] => images.images.views.filter((_, v) => viewWords(patch, line, v)?.word === word).map((v) => v.id);
  const parts = [`${images.viewsOfLine(line).length} of ${images.count} images show it`];
  const [differ, lack] = [named('differs'), named('missing')];
  if (differ.length > 0) parts.push(`${differ.join(', ')} ${differ.length > 1 ? 'differ' : 'differs'}`);
  if (lack.length > 0) parts.push(`missing in ${lack.join(', ')}`);
  return parts.join('; ');
}
