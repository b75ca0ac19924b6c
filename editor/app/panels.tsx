import type { ReactNode } from 'react';
import { FEATURES, type Panel } from '../features/index.ts';

/** A panel as it is shown. */
export interface SidePanel extends Pick<Panel, 'id' | 'title' | 'icon'> {
  readonly content: ReactNode;
}

function shown({ id, title, icon, content: Content }: Panel): SidePanel {
  const sections = FEATURES.flatMap(({ section }) => (section?.panel === id ? section.content : []));
  return { id, title, icon, content: <Content sections={sections} /> };
}

const at = (side: Panel['side'], place: Panel['place']): readonly SidePanel[] =>
  FEATURES.flatMap(({ panel }) => (panel?.side === side && panel.place === place ? shown(panel) : []));

/** Always shown at the top of the left side, and at the bottom of the right one. */
export const [LEVELS] = at('left', 'fixed');
export const [PROBLEMS] = at('right', 'fixed');

/** Shown one at a time. */
export const LEFT = at('left', 'tab');
export const RIGHT = at('right', 'tab');

export const PANELS: readonly SidePanel[] = [LEVELS, ...LEFT, ...RIGHT, PROBLEMS];
