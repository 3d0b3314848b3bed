# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The files of an OpenFOAM case: transient laminar flow of second order, with averages from a time on."""
import sections as valve

NU = valve.VISCOSITY / valve.DENSITY
HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"

SCHEMES = """
ddtSchemes { default backward; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linearUpwind grad(U); div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""

SOLUTION = """
solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0.05; }
    pFinal { solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0.01; }
    "U|UFinal" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-7; relTol 0; }
}
PIMPLE { momentumPredictor yes; nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; }
"""


def control(end, average_from, step):
    return f"""
application pimpleFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime {end};
deltaT {step}; adjustTimeStep yes; maxCo 1;
writeControl adjustableRunTime; writeInterval {end}; writeFormat ascii; writePrecision 8; timePrecision 9;
runTimeModifiable no;
functions
{{
    average
    {{
        type fieldAverage; libs (fieldFunctionObjects);
        timeStart {average_from}; writeControl writeTime;
        fields ( U {{ mean on; prime2Mean on; base time; }} p {{ mean on; prime2Mean on; base time; }} );
    }}
    watch
    {{
        type probes; libs (sampling); fields (U p); writeControl timeStep; writeInterval 10;
        probeLocations ( ({valve.THROAT} 1e-5 5e-4) (0 1e-5 5e-4) (0 0.012 5e-4) ({valve.MEASURED_UPSTREAM} 1e-5 5e-4) );
    }}
}}
"""


def velocity(speed, whole):
    axis = "" if whole else "axis { type symmetryPlane; }"
    return f"""
dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{{
    inlet
    {{
        type exprFixedValue; value uniform ({speed} 0 0);
        valueExpr "vector({speed} * (1 - sqr(pos().y() / {valve.HALF_WIDTH})), 0, 0)";
    }}
    outlet {{ type inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0); }}
    "wall|leaflets" {{ type noSlip; }}
    frontAndBack {{ type empty; }}
    {axis}
}}
"""


def pressure(whole):
    axis = "" if whole else "axis { type symmetryPlane; }"
    return f"""
dimensions [0 2 -2 0 0 0 0];
internalField uniform 0;
boundaryField
{{
    outlet {{ type fixedValue; value uniform 0; }}
    "inlet|wall|leaflets" {{ type zeroGradient; }}
    frontAndBack {{ type empty; }}
    {axis}
}}
"""


def sample(places):
    """Reads averages at places: a name for each section and its (x, y)."""
    sets = "".join(
        f"    {name} {{ type cloud; axis xyz; points ({' '.join(f'({x:.9g} {y:.9g} 5e-4)' for x, y in where)}); }}\n"
        for name, where in places.items())
    return f"""
type sets; libs (sampling);
interpolationScheme cellPoint; setFormat raw; fields (UMean pMean UPrime2Mean);
sets
(
{sets});
"""


def start(speed, x, y):
    """u at the start, as flow.initial_velocity of cases/heart_valve/rigid.toml."""
    wide = valve.HALF_WIDTH
    half = wide
    if -0.0182 < x < -0.0057:
        half = wide - 0.87 * (x + 0.0182)
    elif -0.0057 <= x < 0.0548:
        half = 0.0016 + 0.18 * (x + 0.0057)
    return speed * wide / half * (1 - (y / half)**2) if abs(y) < half else 0.0


def write_case(folder, speed, whole, end, average_from, step, places):
    for name in ("0", "constant", "system"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    files = {
        ("0", "U", "volVectorField"): velocity(speed, whole),
        ("0", "p", "volScalarField"): pressure(whole),
        ("constant", "transportProperties", "dictionary"): f"transportModel Newtonian; nu {NU:.10g};\n",
        ("constant", "turbulenceProperties", "dictionary"): "simulationType laminar;\n",
        ("system", "controlDict", "dictionary"): control(end, average_from, step),
        ("system", "fvSchemes", "dictionary"): SCHEMES,
        ("system", "fvSolution", "dictionary"): SOLUTION,
        ("system", "atSections", "dictionary"): sample(places),
        ("system", "mapFieldsDict", "dictionary"): "patchMap (); cuttingPatches ();\n",
    }
    for (place, name, kind), text in files.items():
        (folder / place / name).write_text(HEAD.format(kind, name) + text, encoding="utf-8")
