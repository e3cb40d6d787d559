using System.Globalization;
using RigidBodyDynamics.Lab.Output;
using RigidBodyDynamics.Lab.Report;
using SkiaSharp;

namespace RigidBodyDynamics.Lab.Animation;

/// <summary>The replay of a run as an animated picture for slides: the paths of the bodies, and a close-up of each.</summary>
internal sealed class ReplayPicture
{
    private const int Width = 760, Height = 400, Margin = 16, Top = 44, MapWidth = 400, MostFrames = 150, MostBodies = 4;
    private static readonly SKColor[] Colors =
        [SKColor.Parse("#1f5fa8"), SKColor.Parse("#c8550a"), SKColor.Parse("#0b7285"), SKColor.Parse("#b3261e")];

    private static readonly SKColor Ink = SKColor.Parse("#1c1d1f"), Faint = SKColor.Parse("#d4d6d8");

    private readonly Motion _motion;
    private readonly string _title;
    private readonly IReadOnlyList<Track> _tracks;
    private readonly SKTypeface _face = SKTypeface.FromFamilyName(PictureWords.Font);
    private readonly double _left, _bottom, _pixelsPerMetre, _mostSpin, _mostMomentum;

    private ReplayPicture(string title, Motion motion)
    {
        _title = title;
        _motion = motion;
        _tracks = [.. motion.Tracks.Take(MostBodies)];
        IEnumerable<Vector3d> all = _tracks.SelectMany(track => track.States).Select(state => state.Position);
        double width = all.Max(p => p.X) - all.Min(p => p.X), height = all.Max(p => p.Y) - all.Min(p => p.Y);
        // at least two metres of ground, so that a body at rest is not magnified
        double span = Math.Max(2, Math.Max(width / (MapWidth - 4 * Margin), height / (Height - Top - 4 * Margin)) * (MapWidth - 4 * Margin));
        _pixelsPerMetre = (MapWidth - 4 * Margin) / span;
        _left = 0.5 * (all.Max(p => p.X) + all.Min(p => p.X));
        _bottom = 0.5 * (all.Max(p => p.Y) + all.Min(p => p.Y));
        _mostSpin = Most(track => track.States.Max(state => state.AngularVelocity.Length));
        _mostMomentum = Most(track => track.States.Max(state => Conserved.AngularMomentum(state, track.Mass).Length));
    }

    /// <summary>Writes the animated picture of a run, in real time where that is not too long.</summary>
    public static void Write(string title, Motion motion, string path)
    {
        ReplayPicture picture = new(title, motion);
        int moments = motion.At.Count, frames = Math.Min(moments, MostFrames);
        double duration = motion.Steps.StartOf(motion.At[^1]);
        AnimatedPng png = new(Width, Height, (int)Math.Clamp(Math.Round(100 * duration / frames), 2, 20));
        for (int frame = 0; frame < frames; frame++)
        {
            int moment = frames == 1 ? 0 : (int)Math.Round((moments - 1.0) * frame / (frames - 1));
            using SKSurface surface = SKSurface.Create(new SKImageInfo(Width, Height, SKColorType.Rgba8888, SKAlphaType.Opaque));
            picture.Draw(surface.Canvas, moment);
            using SKImage image = surface.Snapshot();
            png.Add(image);
        }

        File.WriteAllBytes(path, png.ToArray());
    }

    private void Draw(SKCanvas canvas, int moment)
    {
        canvas.Clear(SKColors.White);
        double time = _motion.Steps.StartOf(_motion.At[moment]);
        Text(canvas, _title, Margin, 28, 17, Ink);
        string held = string.Join("  ", _motion.Held.Where(held => held.IsKey && held.From <= time && time < held.To).Select(held => PictureWords.Say(held.Name)));
        Text(canvas, time.ToString("0.00 s", CultureInfo.InvariantCulture) + (held.Length > 0 ? "   " + held : string.Empty), MapWidth + Margin, 28, 17, Ink);
        Text(canvas, "ω", Width - 7 * Margin, Height - Margin, 15, Stage.Spin);
        Text(canvas, PictureWords.Say("L, dashed"), Width - 6 * Margin + 4, Height - Margin, 15, Stage.Momentum);
        Map(canvas, moment);
        int rows = (_tracks.Count + 1) / 2, columns = _tracks.Count > 1 ? 2 : 1;
        for (int i = 0; i < _tracks.Count; i++)
        {
            float width = (Width - MapWidth - Margin) / (float)columns, height = (Height - Top - Margin) / (float)rows;
            SKRect frame = SKRect.Create(MapWidth + i % columns * width, Top + i / columns * height, width, height);
            Track track = _tracks[i];
            BodyState state = track.States[moment];
            Text(canvas, track.Name, frame.Left + Margin, frame.Top + 16, 14, Colors[i]);
            Stage.Draw(
                canvas,
                frame,
                track.Edges,
                state.Orientation * track.Shape.PrincipalFrame,
                Colors[i],
                state.AngularVelocity / _mostSpin,
                Conserved.AngularMomentum(state, track.Mass) / _mostMomentum);
        }
    }

    // the paths so far in x and y, with a scale of one metre
    private void Map(SKCanvas canvas, int moment)
    {
        using SKPaint border = new() { Color = Faint, Style = SKPaintStyle.Stroke, IsAntialias = true };
        canvas.DrawRect(SKRect.Create(Margin, Top, MapWidth - 2 * Margin, Height - Top - Margin), border);
        for (int i = _tracks.Count - 1; i >= 0; i--)
        {
            using SKPath way = new();
            way.AddPoly([.. _tracks[i].States.Take(moment + 1).Select(state => Place(state.Position))], close: false);
            using SKPaint line = new() { Color = Colors[i], Style = SKPaintStyle.Stroke, StrokeWidth = 2, IsAntialias = true };
            line.PathEffect = i % 2 == 1 ? SKPathEffect.CreateDash([6, 4], 0) : null;
            canvas.DrawPath(way, line);
            using SKPaint dot = new() { Color = Colors[i], IsAntialias = true };
            canvas.DrawCircle(Place(_tracks[i].States[moment].Position), 6, dot);
        }

        double length = Math.Pow(10, Math.Floor(Math.Log10(100 / _pixelsPerMetre)));
        using SKPaint ruler = new() { Color = Ink, StrokeWidth = 2, IsAntialias = true };
        float right = MapWidth - 2 * Margin, bottom = Height - 2 * Margin;
        canvas.DrawLine(right - (float)(length * _pixelsPerMetre), bottom, right, bottom, ruler);
        Text(canvas, length.ToString("0.##", CultureInfo.InvariantCulture) + " m", right - (float)(length * _pixelsPerMetre), bottom - 6, 13, Ink);
    }

    private SKPoint Place(Vector3d p) => new(
        (float)(0.5 * MapWidth + (p.X - _left) * _pixelsPerMetre),
        (float)(0.5 * (Height + Top - Margin) - (p.Y - _bottom) * _pixelsPerMetre));

    private void Text(SKCanvas canvas, string text, float x, float y, float size, SKColor color)
    {
        using SKFont font = new(_face, size);
        using SKPaint paint = new() { Color = color, IsAntialias = true };
        canvas.DrawText(text, x, y, font, paint);
    }

    private double Most(Func<Track, double> of)
    {
        double most = _tracks.Max(of);
        return most > 0 ? most : 1;
    }
}
