"""Rows of the worked office example: a one-way slab of three spans on beams of two spans, typed in SI for EN
1992-1-1 and in US units for ACI 318-19. Made up, of sizes that are built."""

from examples.paper.members import Row


def si() -> list[Row]:
    """Strip of 1 m and beam, EN 1992-1-1."""
    code = {
        "standard": "EN 1992-1-1",
        "exposure": "XC1",
        "duct [mm]": 18,
        "RH [%]": 50,
        "live_sustained": 0.3,
        "fy [MPa]": 500,
        "fc [MPa]": 35,
        "mu [1/rad]": 0.06,
        "k_ec2 [rad/m]": 0.01,
    }
    slab = {
        "member": "Slab",
        "kind": "slab",
        "span [mm]": "7500; 7500; 7500",
        **{"b [mm]": 1000, "h [mm]": 180},
        "Aps [mm2]": 300,
        "dp [mm]": "90; 135; 45; 135; 45; 135; 90",
        "fpj [MPa]": 1395,
        **{"As [mm2]": 393, "ds [mm]": 150, "As_top [mm2]": 393, "ds_top [mm]": 30},
        "w_dead [kN/m]": 1.0,
        "w_live [kN/m]": 2.0,
        "note": "Strip of 1 m: two 15.7 mm monostrands, bars d10 at 200 mm in both faces.",
    }
    beam = {
        "member": "Beam",
        "span [mm]": "12000; 12000",
        "shape": "tee",
        **{"b [mm]": 2400, "h [mm]": 750, "bw [mm]": 450, "hf [mm]": 180},
        "Aps [mm2]": 1800,
        "dp [mm]": "260; 670; 90; 670; 260",
        "fpj [MPa]": 1395,
        "jack": "both",
        **{"As [mm2]": 1964, "ds [mm]": 690, "As_top [mm2]": 2454, "ds_top [mm]": 60},
        **{"Av [mm2]": 226, "s [mm]": 200, "fyt [MPa]": 500},
        "w_dead [kN/m]": 30,
        "w_live [kN/m]": 15,
        "bar_diameter [mm]": 25,
        "note": "Twelve 15.7 mm monostrands; bars d25, four below and five above; stirrups d12 at 200 mm.",
    }
    return [slab | code, beam | code]


def us() -> list[Row]:
    """Strip of 3 ft and beam, ACI 318-19."""
    code = {
        "standard": "ACI 318-19",
        "duct [in]": 0.7,
        "RH [%]": 60,
        "live_sustained": 0.25,
        "fy [ksi]": 60,
        "fc [ksi]": 5,
        "fci [ksi]": 3,
        "fpu [ksi]": 270,
        "Ep [ksi]": 28500,
        "mu [1/rad]": 0.07,
        "K [1/ft]": 0.001,
        "set [in]": 0.25,
    }
    slab = {
        "member": "Slab",
        "kind": "slab",
        "span [ft]": "25; 25; 25",
        **{"b [in]": 36, "h [in]": 7},
        "Aps [in2]": 0.306,
        "dp [in]": "3.5; 5.75; 1.25; 5.75; 1.25; 5.75; 3.5",
        "fpj [ksi]": 200,
        **{"As [in2]": 0.6, "ds [in]": 6, "As_top [in2]": 0.6, "ds_top [in]": 1},
        "w_dead [kip/ft]": 0.06,
        "w_live [kip/ft]": 0.12,
        "note": "Strip of 3 ft: two 1/2 in monostrands, three #4 in both faces.",
    }
    beam = {
        "member": "Beam",
        "span [ft]": "40; 40",
        "shape": "tee",
        **{"b [in]": 96, "h [in]": 30, "bw [in]": 18, "hf [in]": 7},
        "Aps [in2]": 1.836,
        "dp [in]": "10; 26.5; 3.5; 26.5; 10",
        "fpj [ksi]": 200,
        "jack": "both",
        **{"As [in2]": 3.16, "ds [in]": 27.5, "As_top [in2]": 4.74, "ds_top [in]": 2.5},
        **{"Av [in2]": 0.4, "s [in]": 9, "fyt [ksi]": 60},
        "w_dead [kip/ft]": 2.0,
        "w_live [kip/ft]": 1.0,
        "note": "Twelve 1/2 in monostrands; #8, four in the web and six over it; stirrups #4 at 9 in.",
    }
    return [slab | code, beam | code]
