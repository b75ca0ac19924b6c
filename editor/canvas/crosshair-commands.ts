import type { Command } from '../core/commands/index.ts';
import type { Crosshair, Stride } from './crosshair.ts';
import type { Point } from './view.ts';

/** What keys do on the canvas, for screen readers. */
export const CROSSHAIR_HELP =
  'Enter, or the key of a tool, shows a crosshair. Arrows move it by the grid, with Shift by 8 grid lines, with Alt or Ctrl by 1 px. ' +
  'Enter uses the tool at the crosshair: it adds an object or selects what is there; Shift keeps the tool or adds to the selection. ' +
  'D starts a drag at the crosshair: arrows then move or resize the object there, or select an area, and D ends the drag. ' +
  'Esc hides the crosshair; arrows then nudge the selection.';

const ARROWS = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'] as const;
const STEPS: Readonly<Record<string, Point>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};

/** One step in the direction of an arrow key. */
export const stepOf = (press: KeyboardEvent | undefined): Point => STEPS[press?.key ?? ''] ?? { x: 0, y: 0 };

/** The arrow keys with a modifier. */
export const arrowsWith = (modifier: string): readonly string[] => ARROWS.map((arrow) => `${modifier}${arrow}`);

/**
 * The commands of the crosshair, which uses tools with the keyboard. They take precedence over nudging: while the crosshair is
 * shown, arrows move it.
 * @param isSelected whether anything is selected: then arrows nudge it while the crosshair is hidden
 */
export function crosshairCommands(crosshair: Crosshair, isSelected: () => boolean): readonly Command[] {
  const needsShown = () => (crosshair.isShown() ? null : 'show the crosshair first');
  const needsArrows = () => (crosshair.isShown() || (crosshair.hasFocus() && !isSelected()) ? null : 'show the crosshair first');
  const isFree = () => crosshair.hasFocus() || window.document.activeElement === window.document.body;
  const move = (stride: Stride, title: string, keys: readonly string[], needs: () => string | null): Command => ({
    id: `crosshair.move-${stride}`,
    title,
    group: 'Crosshair',
    keys,
    needs,
    hidden: true,
    run: (press) => crosshair.move(stepOf(press), stride, press?.repeat === true),
  });
  return [
    { id: 'crosshair.show', title: 'Show the crosshair', group: 'Crosshair', run: () => crosshair.show() },
    {
      id: 'crosshair.use',
      title: 'Show the crosshair, then use the tool there; Shift keeps the tool or adds to the selection',
      group: 'Crosshair',
      keys: ['Enter', 'Shift+Enter'],
      needs: () => (isFree() ? null : 'go to the canvas first'),
      hidden: true,
      run(press) {
        if (press?.repeat === true) return;
        if (crosshair.isShown()) crosshair.use(press?.shiftKey === true);
        else crosshair.show();
      },
    },
    {
      id: 'crosshair.hold',
      title: 'Start or end a drag at the crosshair: move, resize, select an area',
      group: 'Crosshair',
      keys: ['d', 'Shift+d'],
      needs: needsShown,
      hidden: true,
      run(press) {
        if (press?.repeat !== true) crosshair.hold(press?.shiftKey === true);
      },
    },
    move('grid', 'Move the crosshair by the grid', arrowsWith(''), needsArrows),
    move('far', 'Move the crosshair by 8 grid lines', arrowsWith('Shift+'), needsArrows),
    move('fine', 'Move the crosshair by 1 px', [...arrowsWith('Alt+'), ...arrowsWith('$mod+')], needsShown),
  ];
}
