import type { Command } from '../../commands/index.ts';
import type { Point } from '../view.ts';
import type { Crosshair } from './crosshair.ts';
import type { Stride } from './crosshair-place.ts';

/** What keys do on the canvas, for who hears it instead of seeing the cheat sheet. */
export const CROSSHAIR_HELP =
  'Enter, or the key of a tool, shows a crosshair. Arrows move it by the grid, with Shift by 8 lines of the grid, with Alt or Ctrl by 1 px. ' +
  'Enter uses the tool there: it adds an object or selects what lies there; with Shift the tool stays in hand, or the selection grows. ' +
  'D takes hold there: then arrows move or resize what is held, or select what lies in a rectangle, and D lets go. ' +
  'Esc puts the crosshair away; without it arrows nudge what is selected.';

const ARROWS = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'] as const;
const STEPS: Readonly<Record<string, Point>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};

/** One step the way that an arrow points. */
export const stepOf = (press: KeyboardEvent | undefined): Point => STEPS[press?.key ?? ''] ?? { x: 0, y: 0 };

/** The arrows with a modifier. */
export const arrowsWith = (modifier: string): readonly string[] => ARROWS.map((arrow) => `${modifier}${arrow}`);

/**
 * The tool in hand, used by keys. They come before the nudges: as long as the crosshair is shown arrows are its own.
 * @param isSelected whether anything is: then arrows without the crosshair nudge it
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
      title: 'Show the crosshair; use the tool there. With Shift it stays in hand, or adds to the selection',
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
      title: 'Take hold there and let go: moves, resizes, selects in a rectangle',
      group: 'Crosshair',
      keys: ['d', 'Shift+d'],
      needs: needsShown,
      hidden: true,
      run(press) {
        if (press?.repeat !== true) crosshair.hold(press?.shiftKey === true);
      },
    },
    move('grid', 'Move the crosshair by the grid', arrowsWith(''), needsArrows),
    move('far', 'Move the crosshair by 8 lines of the grid', arrowsWith('Shift+'), needsArrows),
    move('fine', 'Move the crosshair by 1 px', [...arrowsWith('Alt+'), ...arrowsWith('$mod+')], needsShown),
  ];
}
