import type { Editor } from '../core/context/index.ts';
import { LEFT, RIGHT } from './panels.tsx';

/** Brings a panel to the front. @param id the id of a panel of a feature */
export function showPanel({ session }: Pick<Editor, 'session'>, id: string): void {
  const { panels } = session.getState();
  const left = LEFT.some((panel) => panel.id === id) ? id : panels.left;
  const right = RIGHT.some((panel) => panel.id === id) ? id : panels.right;
  session.setState({ panels: { left, right, phone: id } });
}
