import { Activity } from 'lucide-react';
import { type ReactNode, useSyncExternalStore } from 'react';
import { Group, Panel, Separator } from 'react-resizable-panels';
import { useEditor, useSession } from '../context/index.ts';
import { Button } from '../ui/index.ts';

/** A panel of its own on a phone, a region at the side of a wide screen. */
export interface SidePanel {
  readonly id: string;
  readonly title: string;
  readonly icon: ReactNode;
  readonly content: ReactNode;
}

interface LayoutProps {
  /** From top to bottom. */
  readonly left: readonly [ReactNode, ReactNode];
  readonly canvas: ReactNode;
  readonly right: readonly [ReactNode, ReactNode];
  readonly timeline: ReactNode;
  /** What the left and right regions hold, one at a time where there is no room beside the canvas. */
  readonly panels: readonly SidePanel[];
}

/** px below which there is no room for regions beside the canvas */
const WIDE = 820;
const wide = matchMedia(`(min-width: ${WIDE}px)`);

function useWide(): boolean {
  return useSyncExternalStore(
    (listener) => {
      wide.addEventListener('change', listener);
      return () => wide.removeEventListener('change', listener);
    },
    () => wide.matches,
  );
}

function NarrowLayout({ canvas, timeline, panels }: LayoutProps) {
  const { session } = useEditor();
  const shown = useSession((state) => state.panels.phone);
  const show = (phone: string | null) => session.setState({ panels: { ...session.getState().panels, phone } });
  const all = [{ id: 'timeline', title: 'Timeline', icon: <Activity size={17} />, content: timeline }, ...panels];
  const panel = all.find(({ id }) => id === shown);
  return (
    <div className="narrow">
      <main className="region region--canvas">{canvas}</main>
      {panel !== undefined && <section className="region narrow__sheet">{panel.content}</section>}
      <nav className="narrow__tabs" aria-label="Panels">
        {all.map(({ id, title, icon }) => (
          <Button key={id} hint={title} icon={icon} pressed={id === shown} onClick={() => show(id === shown ? null : id)}>
            {title}
          </Button>
        ))}
      </nav>
    </div>
  );
}

/** Two panels, one above the other. */
function Side({
  id,
  parts,
  share,
}: {
  readonly id: string;
  readonly parts: readonly [ReactNode, ReactNode];
  readonly share: string;
}) {
  return (
    <Group orientation="vertical" id={id}>
      <Panel id={`${id}-top`} minSize="80px">
        <div className="region">{parts[0]}</div>
      </Panel>
      <Separator className="divider" />
      <Panel id={`${id}-bottom`} defaultSize={share} minSize="80px">
        <div className="region">{parts[1]}</div>
      </Panel>
    </Group>
  );
}

/** The three fixed regions and the timeline, with dividers that can be dragged or moved by keys. */
export function Layout(props: LayoutProps) {
  if (!useWide()) return <NarrowLayout {...props} />;
  const { left, canvas, right, timeline } = props;
  return (
    <Group className="regions" orientation="horizontal" id="regions">
      <Panel id="left" defaultSize="250px" minSize="180px" maxSize="420px" groupResizeBehavior="preserve-pixel-size">
        <aside className="region" aria-label="Levels and objects">
          <Side id="left-side" parts={left} share="55%" />
        </aside>
      </Panel>
      <Separator className="divider" />
      <Panel id="middle" minSize="300px">
        <Group orientation="vertical" id="middle-regions">
          <Panel id="canvas" minSize="160px">
            <main className="region region--canvas">{canvas}</main>
          </Panel>
          <Separator className="divider" />
          <Panel id="timeline" defaultSize="230px" minSize="120px" maxSize="420px" groupResizeBehavior="preserve-pixel-size">
            <section className="region" aria-label="Timeline">
              {timeline}
            </section>
          </Panel>
        </Group>
      </Panel>
      <Separator className="divider" />
      <Panel id="right" defaultSize="300px" minSize="220px" maxSize="520px" groupResizeBehavior="preserve-pixel-size">
        <aside className="region" aria-label="Inspector and problems">
          <Side id="right-side" parts={right} share="30%" />
        </aside>
      </Panel>
    </Group>
  );
}
