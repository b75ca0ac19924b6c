import { Braces, Copy, FileImage, Image } from 'lucide-react';
import { Tabs } from 'radix-ui';
import { useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { formatLevel, leavingFolder } from '../../../schema/index.ts';
import {
  LevelContext,
  useDocument,
  useEditor,
  useFolderTerms,
  useLevel,
  useOverlay,
  usePageTheme,
  useSession,
} from '../../core/context/index.ts';
import { copyText, type ExportedFile, keepFile, levelFile, pictureSvg, toPng } from '../../core/exchange/index.ts';
import { Button, Dialog, NumberField } from '../../core/ui/index.ts';
import { ImportTab } from './ImportTab.tsx';
import { LinkTab } from './LinkTab.tsx';
import { PublishTab } from './PublishTab.tsx';

/** Imports and exports levels. */
export function ShareDialog() {
  const overlay = useSession((state) => state.overlay);
  const level = useStore(useEditor().open);
  const dialog = useOverlay('share', 'open', 'publish');
  const first = overlay === 'publish' ? 'publish' : overlay === 'open' || level === null ? 'import' : 'export';
  return (
    <Dialog
      {...dialog}
      wide
      title={overlay === 'publish' ? 'Publish' : 'Import, export, link'}
      about="Levels stay on this machine: a link contains the level itself and is not sent to a server."
    >
      <LevelContext.Provider value={level}>
        <Tabs.Root key={first} defaultValue={first}>
          <Tabs.List className="tabs share__tabs" aria-label="Ways to share">
            <Tabs.Trigger value="export" className="tabs__tab" disabled={level === null}>
              Export
            </Tabs.Trigger>
            <Tabs.Trigger value="link" className="tabs__tab" disabled={level === null}>
              Link
            </Tabs.Trigger>
            <Tabs.Trigger value="publish" className="tabs__tab">
              Publish
            </Tabs.Trigger>
            <Tabs.Trigger value="import" className="tabs__tab">
              Import
            </Tabs.Trigger>
          </Tabs.List>
          <Tabs.Content value="export">{level !== null && <ExportTab />}</Tabs.Content>
          <Tabs.Content value="link">{level !== null && <LinkTab />}</Tabs.Content>
          <Tabs.Content value="publish">
            <PublishTab />
          </Tabs.Content>
          <Tabs.Content value="import">
            <ImportTab onClose={dialog.onClose} />
          </Tabs.Content>
        </Tabs.Root>
      </LevelContext.Provider>
    </Dialog>
  );
}

/** px */
const PREVIEW = 560;

/** Exports the open level as a file or a picture. */
function ExportTab() {
  const { notices } = useEditor();
  const { opened, proof } = useLevel();
  const open = useDocument((state) => state.file);
  const folder = useFolderTerms();
  const [withRules, setWithRules] = useState(true);
  const whole = useMemo(() => leavingFolder(open, folder.rules), [open, folder.rules]);
  const file = withRules ? whole : open;
  const shown = usePageTheme();
  const [theme, setTheme] = useState(shown);
  const [withRun, setWithRun] = useState(true);
  const [width, setWidth] = useState(1280);
  const preview = useMemo(() => {
    const svg = pictureSvg(proof.proof(), { theme, width: PREVIEW, withRun });
    return `data:image/svg+xml,${encodeURIComponent(svg)}`;
  }, [proof, theme, withRun]);
  const stem = opened.id().split('/').at(-1) ?? 'level';

  const keep = async (make: () => ExportedFile | Promise<ExportedFile>) => {
    try {
      const file = await make();
      if (await keepFile(file)) notices.show('info', `Saved ${file.name}.`, { topic: 'export' });
    } catch (error) {
      notices.show('error', `The export failed: ${error instanceof Error ? error.message : error}.`, { topic: 'export' });
    }
  };
  const svg = () => pictureSvg(proof.proof(), { theme, width, withRun });

  return (
    <div className="share">
      <section className="share__part" aria-label="Level file">
        <h3 className="share__title">Level file</h3>
        <p className="share__about">The file that gq check, gq render and this editor read.</p>
        {whole !== open && (
          <label className="share__check">
            <input type="checkbox" checked={withRules} onChange={(event) => setWithRules(event.target.checked)} />
            include the rules of {folder.file}, so that it plays the same elsewhere
          </label>
        )}
        <div className="share__buttons">
          <Button
            hint="Download the level"
            look="main"
            icon={<Braces size={15} />}
            onClick={() => void keep(() => levelFile(opened.id(), file))}
          >
            {stem}.level.json
          </Button>
          <Button
            hint="Copy the level as text"
            look="outlined"
            icon={<Copy size={15} />}
            onClick={() => void copyText(notices, 'the level', formatLevel(file))}
          >
            Copy as text
          </Button>
        </div>
      </section>
      <section className="share__part" aria-label="Picture">
        <h3 className="share__title">Picture</h3>
        <div className="share__picture">
          <img className="share__preview" src={preview} alt="Preview of the exported level" />
          <div className="share__options">
            <label className="share__check">
              <input type="checkbox" checked={withRun} onChange={(event) => setWithRun(event.target.checked)} />
              include the shown run
            </label>
            <label className="share__check">
              <input
                type="checkbox"
                checked={theme === 'light'}
                onChange={(event) => setTheme(event.target.checked ? 'light' : 'dark')}
              />
              light theme, for printing
            </label>
            <NumberField label="Width" value={width} min={160} max={8192} whole step={10} unit="px" onChange={setWidth} />
            <Button
              hint="Download as a PNG image"
              look="main"
              icon={<Image size={15} />}
              onClick={() => void keep(async () => ({ name: `${stem}.png`, blob: await toPng(svg(), 1) }))}
            >
              PNG
            </Button>
            <Button
              hint="Download as an SVG drawing"
              look="outlined"
              icon={<FileImage size={15} />}
              onClick={() => void keep(() => ({ name: `${stem}.svg`, blob: new Blob([svg()], { type: 'image/svg+xml' }) }))}
            >
              SVG
            </Button>
          </div>
        </div>
      </section>
    </div>
  );
}
