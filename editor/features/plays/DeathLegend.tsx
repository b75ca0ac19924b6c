import { useStore } from 'zustand';
import { plural } from '../../../check/words/index.ts';
import { COLOURS, deathOpacity, ShadeLegend } from '../../canvas/index.ts';
import { useLevel, usePageTheme, useSession } from '../../core/context/index.ts';
import { shelfOf } from '../../core/shelf/index.ts';

/** The legend of the heat map of deaths. Empty while the map is not shown. */
export function DeathLegend() {
  const deaths = useStore(shelfOf(useLevel()).store, (state) => state.deaths);
  const isShown = useSession(({ layers, mode }) => layers.deaths && mode === 'edit');
  const theme = usePageTheme();
  if (deaths === null || !isShown) return null;
  return (
    <ShadeLegend
      label="Heat map of deaths"
      caption={`${plural(deaths.deaths, 'death')}, counted in squares of ${deaths.cellSize} px`}
      map={deaths}
      colour={COLOURS[theme].death}
      opacityOf={deathOpacity}
      corner="right"
    />
  );
}
