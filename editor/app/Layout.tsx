import { Activity } from 'lucide-react';
import { type ReactNode, useEffect, useState } from 'react';
import { Group, Panel, Separator, usePanelRef } from 'react-resizable-panels';
import { mediaOf, useEditor, useMedia, useSession } from '../core/context/index.ts';
import { Button } from '../core/ui/index.ts';
import { useProblemCount } from '../features/index.ts';
import type { SidePanel } from './panels.tsx';

interface LayoutProps {
  /** From top to bottom. */
  readonly left: readonly [ReactNode, ReactNode];
  readonly canvas: ReactNode;
  readonly right: readonly [ReactNode, ReactNode];
  readonly timeline: ReactNode;
  /** The panels of both sides, shown one at a time where there is no room beside the canvas. */
  readonly panels: readonly SidePanel[];
}

function NarrowLayout({ canvas, timeline, panels }: LayoutProps) {
  const { session } = useEditor();
  const shown = useSession((state) => state.panels.phone);
  const show = (phone: string | null) => session.setState({ panels: { ...session.getState().panels, phone } });
  const all = [{ id: 'timeline', title: 'Timeline', icon: <Activity size={17} />, content: timeline }, ...panels];
  // a playtest needs all of a small screen
  const isPlaying = useSession((state) => state.mode === 'play');
  const panel = isPlaying ? undefined : all.find(({ id }) => id === shown);
  return (
    <div className={panel === undefined ? 'narrow' : 'narrow narrow--open'}>
      <main className="region region--canvas">{canvas}</main>
      {panel !== undefined && <section className={`region narrow__sheet narrow__sheet--${panel.id}`}>{panel.content}</section>}
      {!isPlaying && (
        <nav className="narrow__tabs" aria-label="Panels">
          {all.map(({ id, title, icon }) => (
            <Button key={id} hint={title} icon={icon} pressed={id === shown} onClick={() => show(id === shown ? null : id)}>
              {title}
            </Button>
          ))}
        </nav>
      )}
    </div>
  );
}

/** Two panels, one above the other. */
function Side({
  id,
  parts,
  share,
  isLine = false,
}: {
  readonly id: string;
  readonly parts: readonly [ReactNode, ReactNode];
  readonly share: string;
  /** The lower panel is collapsed to one line. */
  readonly isLine?: boolean;
}) {
  const lower = usePanelRef();
  useEffect(() => {
    if (isLine) lower.current?.collapse();
    else lower.current?.expand();
  }, [isLine, lower]);
  return (
    <Group orientation="vertical" id={id}>
      <Panel id={`${id}-top`} minSize="80px">
        <div className="region">{parts[0]}</div>
      </Panel>
      <Separator className="divider" />
      <Panel id={`${id}-bottom`} panelRef={lower} defaultSize={share} minSize="80px" collapsible collapsedSize={LINE}>
        <div className="region">{parts[1]}</div>
      </Panel>
    </Group>
  );
}

/** px of a panel that is collapsed to one line */
const LINE = '40px';

/** initial height of the timeline in px, and the largest share of a low page that it takes */
const TIMELINE = { height: 230, share: 0.3 } as const;

/** The two sides, the canvas and the timeline, with dividers that can be dragged or moved with keys. */
function WideLayout({ left, canvas, right, timeline }: LayoutProps) {
  const nothingWrong = useProblemCount() === 0;
  const [timelineHeight] = useState(() => Math.round(Math.min(TIMELINE.height, TIMELINE.share * window.innerHeight)));
  return (
    <Group className="regions" orientation="horizontal" id="regions">
      <Panel id="left" defaultSize="250px" minSize="180px" maxSize="420px" groupResizeBehavior="preserve-pixel-size">
        <aside className="region" aria-label="Levels and objects">
          <Side id="left-side" parts={left} share="55%" />
        </aside>
      </Panel>
      <Separator className="divider" />
      <Panel id="middle" minSize="320px">
        <Group orientation="vertical" id="middle-regions">
          <Panel id="canvas" minSize="55%">
            <main className="region region--canvas">{canvas}</main>
          </Panel>
          <Separator className="divider" />
          <Panel
            id="timeline"
            defaultSize={`${timelineHeight}px`}
            minSize="120px"
            maxSize="420px"
            groupResizeBehavior="preserve-pixel-size"
          >
            <section className="region" aria-label="Timeline">
              {timeline}
            </section>
          </Panel>
        </Group>
      </Panel>
      <Separator className="divider" />
      <Panel id="right" defaultSize="300px" minSize="220px" maxSize="520px" groupResizeBehavior="preserve-pixel-size">
        <aside className="region" aria-label="Inspector and problems">
          <Side id="right-side" parts={right} share="30%" isLine={nothingWrong} />
        </aside>
      </Panel>
    </Group>
  );
}

/** All panels where there is room, else one at a time; the canvas always stays visible. */
export function Layout(props: LayoutProps) {
  return useRoom() === 'wide' ? <WideLayout {...props} /> : <NarrowLayout {...props} />;
}

/**
 * What the page has room for: panels on both sides of the canvas, or one panel at a time, beside the canvas on low pages and
 * below it on narrow ones. Zoom shrinks a page as well: 1440 x 900 at 200 % is 720 x 450.
 */
type Room = 'wide' | 'beside' | 'below';

/** Below this size, too little of the canvas is left between two sides. */
const WIDE = mediaOf('(min-width: 880px) and (min-height: 520px)');
/** From this width on, the canvas keeps 320 px beside a panel. */
const BESIDE = mediaOf('(min-width: 600px) and (orientation: landscape)');

/** The room of the page; the component re-renders when it changes. */
export function useRoom(): Room {
  const [isWide, isBeside] = [useMedia(WIDE), useMedia(BESIDE)];
  return isWide ? 'wide' : isBeside ? 'beside' : 'below';
}
