import { extentOf, type OnCanvas, pointsOfWay, toScreen } from '../../canvas/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';

/** px below the upper edge of the canvas, where the tools stand */
const TOOLS = 56;

/** Finds on the page what the canvas shows; px of the page. @param host the element of the canvas */
export function placesOnPage(level: OpenLevel, { host, canvas }: OnCanvas) {
  const canvasBox = () => host.current?.getBoundingClientRect() ?? { left: 0, top: 0, right: 0, bottom: 0 };
  return {
    /** The box around objects; the upper left corner of the canvas if there are none or they are not in view. */
    whereAre(keys: readonly string[]) {
      const { left, top, right, bottom } = canvasBox();
      const corner = { left, top, right: left, bottom: top + TOOLS };
      const box = keys.length === 0 ? null : extentOf(level.document.file(), level.proof.proof().scene.box, keys);
      if (box === null) return corner;
      const { view } = canvas.getState();
      const from = toScreen(view, { x: box.left, y: box.top });
      const to = toScreen(view, { x: box.right, y: box.bottom });
      const seen = {
        left: left + Math.max(0, from.x),
        top: top + Math.max(0, from.y),
        right: Math.min(right, left + to.x),
        bottom: Math.min(bottom, top + to.y),
      };
      return seen.left <= seen.right && seen.top <= seen.bottom ? seen : corner;
    },
    /** Points of the way of the shown run. */
    wayOnPage() {
      const { left, top } = canvasBox();
      return pointsOfWay(level.proof.proof().run.way, canvas.getState().view).map(({ x, y }) => ({ x: left + x, y: top + y }));
    },
  };
}
