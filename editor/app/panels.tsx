import type { ReactNode } from 'react';
import type { Editor } from '../core/context/index.ts';
import { CANVAS_LAYERS, type LayerSwitch } from '../core/session/index.ts';
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

/** Brings a panel to the front. @param id the id of a panel of a feature */
export function showPanel({ session }: Pick<Editor, 'session'>, id: string): void {
  const { panels } = session.getState();
  const left = LEFT.some((panel) => panel.id === id) ? id : panels.left;
  const right = RIGHT.some((panel) => panel.id === id) ? id : panels.right;
  session.setState({ panels: { left, right, phone: id } });
}

/** All layers over the level that can be shown and hidden. */
export const LAYERS: readonly LayerSwitch[] = [...CANVAS_LAYERS, ...FEATURES.flatMap(({ layers }) => layers ?? [])];
