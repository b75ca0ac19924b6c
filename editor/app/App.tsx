import { Tabs, Tooltip } from 'radix-ui';
import { useEffect } from 'react';
import { useStore } from 'zustand';
import { CanvasView } from '../canvas/index.ts';
import { type Command, listenToKeys, listenToPads } from '../core/commands/index.ts';
import { errorInWords, problemsInWords } from '../core/files/index.ts';
import { openListed } from '../core/levels/index.ts';
import { laterCover, SamplesButton } from '../core/panel/index.ts';
import { Button, keepFocus } from '../core/ui/index.ts';
import { FEATURES } from '../features/index.ts';
import { Timeline } from '../timeline/index.ts';
import './app.css';
import { type Editor, EditorContext, LevelContext, useEditor, useLevel, useLevelKey, useSession } from '../core/context/index.ts';
import { appCommands } from './app-commands.ts';
import { CommandPalette } from './CommandPalette.tsx';
import { Layout, useRoom } from './Layout.tsx';
import { NoticeList } from './NoticeList.tsx';
import { LEFT, LEVELS, PANELS, PROBLEMS, RIGHT, type SidePanel, showPanel } from './panels.tsx';
import { HeldBar } from './SaveStatus.tsx';
import { StatusBar } from './StatusBar.tsx';
import { Toolbar } from './Toolbar.tsx';
import { TopBar } from './TopBar.tsx';

const CheatSheet = laterCover(
  ({ overlay }) => overlay === 'cheatSheet',
  () => import('./CheatSheet.tsx').then((there) => there.CheatSheet),
);
const SettingsDialog = laterCover(
  ({ overlay }) => overlay === 'settings',
  () => import('./SettingsDialog.tsx').then((there) => there.SettingsDialog),
);

const CANVAS_PARTS = FEATURES.flatMap(({ name, canvas }) => (canvas === undefined ? [] : { name, ...canvas }));
const TIMELINE_PARTS = FEATURES.flatMap(({ name, timeline }) => (timeline === undefined ? [] : { name, ...timeline }));

/** The panels of one side, shown one at a time. */
function SideTabs({
  side,
  label,
  panels,
}: {
  readonly side: 'left' | 'right';
  readonly label: string;
  readonly panels: readonly SidePanel[];
}) {
  const { session } = useEditor();
  const shown = useSession((state) => state.panels[side]);
  return (
    <Tabs.Root
      className="panel"
      value={shown}
      onValueChange={(id) => session.setState({ panels: { ...session.getState().panels, [side]: id } })}
    >
      <Tabs.List className="tabs" aria-label={label}>
        {panels.map(({ id, title }) => (
          <Tabs.Trigger key={id} value={id} className="tabs__tab">
            {title}
          </Tabs.Trigger>
        ))}
      </Tabs.List>
      {panels.map(({ id, content }) => (
        <Tabs.Content key={id} value={id} className="panel">
          {content}
        </Tabs.Content>
      ))}
    </Tabs.Root>
  );
}

/** Commands that bring a panel to the front. */
const panelCommands = (editor: Editor): readonly Command[] =>
  PANELS.map(({ id, title }) => ({
    id: `panel.${id}`,
    title: `Show ${title.toLowerCase()}`,
    group: 'View',
    mode: 'both',
    run: () => showPanel(editor, id),
  }));

/** Registers the commands that are there while a level is open. Renders nothing. */
function LevelCommands() {
  const editor = useEditor();
  const level = useLevel();
  useEffect(
    () => editor.commands.register(FEATURES.flatMap(({ levelCommands }) => levelCommands?.(editor, level) ?? [])),
    [editor, level],
  );
  return null;
}

function LevelScreen() {
  const key = useLevelKey();
  const mode = useSession((state) => state.mode);
  return (
    <>
      <div className="head">
        <TopBar />
        <HeldBar />
      </div>
      <Layout
        left={[LEVELS.content, <SideTabs key="tabs" side="left" label="Objects and runs" panels={LEFT} />]}
        right={[<SideTabs key="tabs" side="right" label="Inspector and tools" panels={RIGHT} />, PROBLEMS.content]}
        canvas={
          <>
            <CanvasView key={key} parts={CANVAS_PARTS} />
            <Toolbar />
            {mode === 'edit' && (
              <div key={`survival ${key}`} className="survival">
                {FEATURES.map(({ name, offer: Offer }) => Offer && <Offer key={name} />)}
              </div>
            )}
            {FEATURES.map(({ name, screen: Screen }) => Screen && <Screen key={name} />)}
          </>
        }
        timeline={<Timeline key={key} parts={TIMELINE_PARTS} />}
        panels={PANELS}
      />
      <StatusBar />
      {FEATURES.map(({ name, watch: Watch }) => Watch && <Watch key={name} />)}
      <LevelCommands />
    </>
  );
}

/** The page while no level is open. */
function EmptyScreen() {
  const editor = useEditor();
  const { workspace, session } = editor;
  const list = useStore(workspace.store, (state) => state.list);
  const error = useStore(workspace.store, (state) => state.error);
  const refused = useStore(workspace.store, (state) => state.refused);
  const fixedId = list?.levels.find(({ id, status }) => id === refused?.id && status === 'valid')?.id;
  // A refused file opens as soon as it is fixed on disk.
  useEffect(() => {
    if (fixedId !== undefined) void openListed(editor, fixedId);
  }, [editor, fixedId]);
  return (
    <>
      <header className="topbar">
        <h1 className="topbar__level">Gravity Quest editor</h1>
      </header>
      <div className={error === null ? 'start' : 'start start--alone'}>
        {/* Without access to the levels, there is nothing to list and no place for a new level. */}
        {error === null && (
          <aside className="region" aria-label="Levels">
            {LEVELS.content}
          </aside>
        )}
        <main className="empty">
          {error !== null ? (
            <p role="alert">{errorInWords(error)}</p>
          ) : list === null ? (
            <p>Loading levels…</p>
          ) : (
            <p role={refused?.opening.kind === 'invalid' ? 'alert' : undefined}>
              {refused?.opening.kind === 'invalid' &&
                `This level can't be read. ${problemsInWords(`${refused.id}.level.json`, refused.opening.problems)} `}
              {list.levels.length === 0 ? 'No levels here yet.' : 'Choose a level or create a new one.'}
            </p>
          )}
          {error !== null && (
            <Button
              hint="Show unsaved changes that this browser has kept"
              look="outlined"
              onClick={() => session.setState({ overlay: 'kept' })}
            >
              Unsaved changes
            </Button>
          )}
          {error === null && (
            <Button hint="Start from a template" look="main" onClick={() => session.setState({ overlay: 'newLevel' })}>
              New level
            </Button>
          )}
          {error === null && list?.levels.length === 0 && <SamplesButton />}
        </main>
      </div>
      <footer className="statusbar" />
    </>
  );
}

function Screen() {
  const editor = useEditor();
  const level = useStore(editor.open);
  const room = useRoom();
  const isCovered = useSession(({ view }) => view === 'pack');
  useTheme();
  useEffect(() => {
    const { commands, session } = editor;
    const forget = commands.register([
      ...appCommands(editor),
      ...FEATURES.flatMap((feature) => feature.commands?.(editor) ?? []),
      ...panelCommands(editor),
    ]);
    const mode = () => session.getState().mode;
    const stops = [
      listenToKeys(window, commands, mode),
      listenToPads(window, commands, mode),
      keepFocus(document),
      ...FEATURES.flatMap(({ start }) => start?.(editor) ?? []),
    ];
    return () => {
      forget();
      for (const stop of stops) stop();
    };
  }, [editor]);
  return (
    <div className={`app app--${room}`}>
      {/* what the view of all levels covers can't be used meanwhile */}
      <div className="app__screen" inert={isCovered}>
        {level === null ? (
          <EmptyScreen />
        ) : (
          <LevelContext.Provider value={level}>
            <LevelScreen />
          </LevelContext.Provider>
        )}
      </div>
      {FEATURES.map(({ name, dialogs: Dialogs }) => Dialogs && <Dialogs key={name} />)}
      <CommandPalette />
      <CheatSheet />
      <SettingsDialog />
      <NoticeList />
    </div>
  );
}

/** The whole page. */
export function App({ editor }: { readonly editor: Editor }) {
  return (
    <EditorContext.Provider value={editor}>
      <Tooltip.Provider delayDuration={500}>
        <Screen />
      </Tooltip.Provider>
    </EditorContext.Provider>
  );
}

/** Sets an attribute of the page to the user's choice or, without one, to the system's. */
function follow(query: string, wanted: (matches: boolean) => string, name: string): () => void {
  const media = matchMedia(query);
  const apply = () => document.documentElement.setAttribute(name, wanted(media.matches));
  apply();
  media.addEventListener('change', apply);
  return () => media.removeEventListener('change', apply);
}

/** Sets the theme and the amount of motion as `data-theme` and `data-motion` of the page. */
function useTheme(): void {
  const { settings } = useEditor();
  const theme = useStore(settings, (state) => state.theme);
  const reduceMotion = useStore(settings, (state) => state.reduceMotion);
  useEffect(
    () =>
      follow('(prefers-color-scheme: light)', (light) => (theme === 'system' ? (light ? 'light' : 'dark') : theme), 'data-theme'),
    [theme],
  );
  useEffect(
    () =>
      follow(
        '(prefers-reduced-motion: reduce)',
        (less) => ((reduceMotion === 'system' ? less : reduceMotion === 'yes') ? 'less' : 'full'),
        'data-motion',
      ),
    [reduceMotion],
  );
}
