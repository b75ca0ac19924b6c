import { EyeOff } from 'lucide-react';
import { useEffect, useLayoutEffect, useRef } from 'react';
import { type StoreApi, useStore } from 'zustand';
import { type Box, type CanvasState, COLOURS, type OnCanvas, toLevel, toScreen, type View } from '../../canvas/index.ts';
import { keyLabel } from '../../core/commands/index.ts';
import { IS_MAC, useEditor, useLevel, usePageTheme, useSelectedKeys, useSession } from '../../core/context/index.ts';
import { objectsOf, placesOf } from '../../core/document/index.ts';
import { Segments } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { drawLeeway, shapesOf } from './leeway-picture.ts';
import { meaningInWords, movedInWords, noteInWords, PLACE_NAMES, reachInWords, samplingInWords } from './leeway-words.ts';
import { leewayOf, watchLeeway } from './watch-leeway.ts';

/** px of screen between samples from which on each is marked */
const APART = 14;
/** the largest width and height of the picture, px */
const MOST = 2400;

/** The zoom for which it is drawn: a step of a half octave, so that it is not drawn anew for every turn of the wheel. */
const drawnZoom = (zoom: number): number => 2 ** (Math.round(2 * Math.log2(zoom)) / 2);

/** What was drawn last. */
interface Drawn {
  readonly frame: Box;
  /** px of the picture per px of the level */
  readonly scale: number;
}

/** Moves the picture to where the view shows it. */
function place(picture: HTMLCanvasElement | null, drawn: Drawn | null, view: View): void {
  if (picture === null || drawn === null) return;
  const { x, y } = toScreen(view, { x: drawn.frame.left, y: drawn.frame.top });
  picture.style.transform = `translate(${x}px, ${y}px) scale(${view.zoom / drawn.scale})`;
}

/**
 * The shade of the places where the selection may stand. It is drawn when something new is known, once per frame at most; a view
 * that moves only moves the picture, and costs nothing.
 */
export function LeewayShade({ canvas }: OnCanvas) {
  const leeway = useStore(leewayOf(useLevel()), (state) => state.answer?.leeway ?? null);
  const isShown = useSession(({ layers, mode }) => layers.leeway && mode === 'edit') && leeway !== null;
  const theme = usePageTheme();
  const view = useStore(canvas, (state) => state.view);
  const zoom = drawnZoom(view.zoom);
  useLeeway(canvas);
  const picture = useRef<HTMLCanvasElement>(null);
  const drawn = useRef<Drawn | null>(null);
  useLayoutEffect(() => place(picture.current, drawn.current, view), [view]);
  useEffect(() => {
    if (leeway === null || !isShown) return;
    const draw = () => {
      const element = picture.current;
      const shapes = shapesOf(leeway, APART / zoom);
      const { frame } = shapes;
      if (element === null || frame === null) return;
      const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
      const scale = Math.min(zoom * Math.min(2, window.devicePixelRatio), MOST / width, MOST / height);
      element.width = Math.max(1, Math.ceil(width * scale));
      element.height = Math.max(1, Math.ceil(height * scale));
      const { leeway: colour, danger, label } = COLOURS[theme];
      drawLeeway(element, shapes, { scale, density: scale / zoom, colour, bad: danger, open: label });
      drawn.current = { frame, scale };
      place(element, drawn.current, canvas.getState().view);
    };
    const asked = requestAnimationFrame(draw);
    return () => cancelAnimationFrame(asked);
  }, [leeway, isShown, theme, zoom, canvas]);
  if (!isShown) return null;
  return (
    <div className="canvas__leeway" aria-hidden>
      <canvas ref={picture} />
    </div>
  );
}

/** Samples where the selection may stand, in what the canvas shows, for as long as that is shown. */
function useLeeway(canvas: StoreApi<CanvasState>): void {
  const { session, settings, desk } = useEditor();
  const level = useLevel();
  useEffect(() => {
    const now = () => {
      const { view } = canvas.getState();
      const from = toLevel(view, { x: 0, y: 0 });
      const to = toLevel(view, { x: view.width, y: view.height });
      return { left: from.x, top: from.y, right: to.x, bottom: to.y };
    };
    const subscribe = (call: () => void) =>
      canvas.subscribe((state, before) => {
        if (state.view !== before.view) call();
      });
    return watchLeeway({ level, session, settings, desk, seen: { now, subscribe } });
  }, [canvas, level, session, settings, desk]);
}

/** The legend of the places where the selection may stand, and how far it may go. Empty while they are not shown. */
export function LeewayLegend({ shortcut }: { readonly shortcut: string }) {
  const { commands } = useEditor();
  const store = leewayOf(useLevel());
  const findings = useStore(store);
  const isShown = useSession(({ layers, mode }) => layers.leeway && mode === 'edit');
  if (!isShown) return null;
  const { answer } = findings;
  return (
    <figure className="shades shades--left leeway-legend" aria-label="Where the selection may stand">
      <figcaption className="leeway-legend__head">
        <b>{answer === null ? 'Where the selection may stand' : `${movedInWords(answer.question)} may stand`}</b>
        <MovedPart />
        {answer !== null && (
          <>
            <p>
              <span className="shades__square leeway-sign" aria-hidden />
              {meaningInWords(answer)}
            </p>
            <p className="leeway-legend__note numbers">{samplingInWords(findings)}</p>
          </>
        )}
        <p className="numbers" role="status">
          {answer === null ? noteInWords(findings) : reachInWords(answer.leeway)}
        </p>
      </figcaption>
      <Button
        hint="Hide where the selection may stand"
        shortcut={keyLabel(shortcut, IS_MAC)}
        icon={<EyeOff size={14} />}
        onClick={() => commands.run('view.layer-leeway')}
      />
    </figure>
  );
}

const ALL = 'both';

/** Which places of a selected object move, if it has several. */
function MovedPart() {
  const level = useLevel();
  const store = leewayOf(level);
  const only = useStore(store, (state) => state.only);
  const keys = useSelectedKeys();
  const found = keys.length === 1 ? objectsOf(level.document.file()).get(keys[0]) : undefined;
  if (found === undefined || placesOf(found).length === 1) return null;
  return (
    <Segments
      label="What is moved"
      value={only === null ? ALL : PLACE_NAMES[only]}
      options={[ALL, ...PLACE_NAMES].map((name) => ({ value: name, title: name }))}
      onChange={(name) =>
        store.setState({ only: name === ALL ? null : PLACE_NAMES.indexOf(name as (typeof PLACE_NAMES)[number]) })
      }
    />
  );
}
