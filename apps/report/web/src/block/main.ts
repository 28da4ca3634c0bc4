// SPDX-License-Identifier: BSD-3-Clause
// Shows the report of a block or the page of one of its patches, depending on the data.
import { readData } from '../data/decode';
import { append, h } from '../ui/dom';
import { BlockPage } from './block_page';
import { PatchPage } from './patch_page';
import type { BlockReport, PatchReport } from './schema';

const root = document.getElementById('app')!;
try {
  const data = readData<BlockReport | PatchReport>(1);
  if (data.page === 'block') new BlockPage(data, root);
  else new PatchPage(data, root);
  document.documentElement.dataset['ready'] = 'true';
} catch (error) {
  append(root, h('p', { class: 'message' }, `The report cannot be shown: ${error instanceof Error ? error.message : String(error)}`));
  throw error;
}
