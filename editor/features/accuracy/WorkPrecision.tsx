import { Maximize2 } from 'lucide-react';
import { type KeyboardEvent, type PointerEvent, useEffect, useId, useMemo, useRef, useState } from 'react';
import type { AccuracyName } from '../../../engine/index.ts';
import { type Diagram, type DrawnDiagram, layOutDiagram } from '../../../picture/accuracy/index.ts';
import { usePageTheme } from '../../core/context/index.ts';
import { Button, Dialog } from '../../core/ui/index.ts';
import { type MeasuredSettings, settingsDiagram } from './measured-settings.ts';

/** The work-precision diagram, small in the panel and large in a dialog. */
export function WorkPrecision({ measured, current }: { readonly measured: MeasuredSettings; readonly current: AccuracyName }) {
  const [isOpen, setOpen] = useState(false);
  const [each, setEach] = useState(false);
  const diagram = useMemo(() => settingsDiagram(measured, current, each), [measured, current, each]);
  return (
    <>
      <Points diagram={diagram} />
      <div className="diagram__tools">
        {measured.runs.length > 1 && (
          <label className="diagram__each">
            <input type="checkbox" checked={each} onChange={(event) => setEach(event.target.checked)} />
            one point a run
          </label>
        )}
        <Button hint="Enlarge the diagram" icon={<Maximize2 size={14} />} onClick={() => setOpen(true)}>
          Enlarge
        </Button>
      </div>
      <Dialog
        open={isOpen}
        wide
        title="What accuracy costs"
        about="Each point is a setting: further left is more accurate, further down is faster."
        onClose={() => setOpen(false)}
      >
        <Points diagram={diagram} isWhole />
      </Dialog>
    </>
  );
}

/** px from a mark within which the pointer means it */
const REACH = 24;

/** px: the diagram is drawn anew when its place has changed by so much */
const STEP = 10;
const NARROWEST = 240;
/** from here on, the whole picture with its title can be read */
const WHOLE_FROM = 760;

const pictureOf = (svg: string): string => `data:image/svg+xml,${encodeURIComponent(svg)}`;

/** A diagram whose points are named by pointer and keys. @param isWhole with title and legend, where there is room */
function Points({ diagram, isWhole = false }: { readonly diagram: Diagram; readonly isWhole?: boolean }) {
  const theme = usePageTheme();
  const id = useId();
  const place = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState<number | null>(null);
  const [chosen, setChosen] = useState<number | null>(null);
  useEffect(() => {
    const element = place.current;
    if (element === null) return;
    const observer = new ResizeObserver(([{ contentRect }]) =>
      setWidth(Math.max(NARROWEST, STEP * Math.floor(contentRect.width / STEP))),
    );
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const drawn = useMemo((): DrawnDiagram | null => {
    if (width === null) return null;
    return isWhole && width >= WHOLE_FROM ? layOutDiagram(diagram, theme) : layOutDiagram(diagram, theme, width);
  }, [diagram, theme, width, isWhole]);
  const marks = drawn?.marks ?? [];
  const failed = marks.filter(({ point }) => point.failures > 0).length;
  const used = marks.findIndex(({ point }) => point.label !== null && point.label === diagram.used);
  // another diagram may have fewer points
  const at = chosen !== null && chosen < marks.length ? chosen : null;

  const nearest = (event: PointerEvent<HTMLElement>) => {
    if (drawn === null) return;
    const box = event.currentTarget.getBoundingClientRect();
    const scale = drawn.width / box.width;
    const away = marks.map(({ x, y }) =>
      Math.hypot(x / scale - (event.clientX - box.left), y / scale - (event.clientY - box.top)),
    );
    const least = Math.min(...away);
    if (least <= REACH) setChosen(away.indexOf(least));
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const step = STEPS[event.key];
    if (step === undefined || marks.length === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const [axis, by] = step;
    const order = [...marks.keys()].sort((a, b) => marks[a][axis] - marks[b][axis] || a - b);
    const last = order.length - 1;
    const from = at === null ? -1 : order.indexOf(at);
    setChosen(order[Math.max(0, Math.min(last, Number.isFinite(by) ? from + by : by > 0 ? last : 0))]);
  };
  return (
    <div ref={place} className="diagram">
      {drawn !== null && (
        <>
          <div className="diagram__picture">
            <img
              src={pictureOf(drawn.svg)}
              alt={`Work-precision diagram: ${marks.length} points, ${failed} of them with a different outcome; ${diagram.used} is ringed`}
            />
            <div
              className="diagram__points"
              role="listbox"
              tabIndex={0}
              aria-label="Points of the diagram"
              aria-activedescendant={at === null ? undefined : `${id}-${at}`}
              onPointerMove={nearest}
              onPointerDown={nearest}
              onFocus={() => setChosen((now) => now ?? Math.max(0, used))}
              onKeyDown={onKeyDown}
            >
              {marks.map(({ point, x, y }, i) => (
                <span
                  // biome-ignore lint/suspicious/noArrayIndexKey: the points of a diagram have no other name
                  key={i}
                  id={`${id}-${i}`}
                  role="option"
                  tabIndex={-1}
                  aria-selected={i === at}
                  aria-label={point.words}
                  className={i === at ? 'diagram__point diagram__point--chosen' : 'diagram__point'}
                  style={{ left: `${(100 * x) / drawn.width}%`, top: `${(100 * y) / drawn.height}%` }}
                />
              ))}
            </div>
          </div>
          <p className="diagram__words numbers">
            {at === null ? 'Point at a mark, or go through them with the arrow keys.' : marks[at].point.words}
          </p>
          {drawn.legend !== null && <img className="diagram__legend" src={pictureOf(drawn.legend)} alt={LEGEND} />}
        </>
      )}
    </div>
  );
}

const LEGEND = 'Legend: each integrator has a mark of its own shape; tests at frames are dashed; another outcome is hollow';

/** Which way a key goes: along the error or along the cost. */
const STEPS: Readonly<Record<string, readonly ['x' | 'y', number]>> = {
  ArrowLeft: ['x', -1],
  ArrowRight: ['x', 1],
  ArrowUp: ['y', -1],
  ArrowDown: ['y', 1],
  Home: ['x', Number.NEGATIVE_INFINITY],
  End: ['x', Number.POSITIVE_INFINITY],
};
